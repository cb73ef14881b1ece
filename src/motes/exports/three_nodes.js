
// The same for WebGPURenderer, whose materials are made of nodes: WGSL on WebGPU, GLSL where it falls back to WebGL 2.  Shadows, instances, batches,
// morph targets and bones come with NodeMaterial.  A parameter is a uniform, or any node of TSL: a texture, an attribute of the mesh.
const classes = new WeakMap();

function nodeMaterialOf(THREE) {
    if (!classes.has(THREE)) classes.set(THREE, nodeMaterialClass(THREE));
    return classes.get(THREE);
}

function nodeMaterialClass(THREE) {
    const { abs, glsl, glslFn, max, normalView, positionViewDirection, uniform, vec3, wgsl, wgslFn } = THREE.TSL;

    const formulas = {
        wgsl: wgslFn(wgslFormula.evaluate, [wgsl(wgslFormula.helpers)]),
        glsl: glslFn(glslFormula.evaluate, [glsl(glslFormula.helpers)]),
    };

    // A light's colour is its irradiance on a surface that faces it, shadows taken off; directions are in view space.
    class MotesLightingModel extends THREE.LightingModel {
        start(builder) {
            const tangent = abs(normalView.z).lessThan(0.9).select(vec3(0, 0, 1), vec3(1, 0, 0)).cross(normalView).normalize().toVar();
            const bitangent = normalView.cross(tangent).toVar();
            this.local = (w) => vec3(w.dot(tangent), w.dot(bitangent), w.dot(normalView)).toVar();
            this.wo = this.local(positionViewDirection);
            super.start(builder);
        }

        direct({ lightDirection, lightColor, reflectedLight }, builder) {
            const wi = this.local(lightDirection);
            const evaluate = formulas[builder.renderer.backend.isWebGPUBackend ? 'wgsl' : 'glsl'];
            const value = evaluate(wi, this.wo, ...parameters.map((parameter) => builder.material[parameter.uniform]));
            reflectedLight.directDiffuse.addAssign(value.mul(lightColor).mul(max(wi.z, 0)));
        }

        indirect(builder) {
            const { ambientOcclusion, iblIrradiance, irradiance, reflectedLight } = builder.context;
            const share = builder.material.motes_albedo.mul(ambientOcclusion).div(Math.PI);
            reflectedLight.indirectDiffuse.addAssign(irradiance.add(iblIrradiance).mul(share));
        }
    }

    return class MotesNodeMaterial extends THREE.NodeMaterial {
        static get type() {
            return 'MotesNodeMaterial';
        }

        constructor(options = {}) {
            super();
            this.name = name;
            this.lights = true;
            this.motes_albedo = uniform(new THREE.Vector3(...albedo));
            for (const parameter of parameters) this[parameter.uniform] = this.uniformOf(parameter.value);
            this.setValues(options);
        }

        uniformOf(value) {
            return Array.isArray(value) ? uniform(new THREE.Vector3(...value)) : uniform(value, 'float');
        }

        // A clone has uniforms of its own.
        copy(source) {
            super.copy(source);
            for (const { uniform: key, value } of parameters) {
                if (!source[key].isUniformNode) continue;
                this[key] = this.uniformOf(Array.isArray(value) ? source[key].value.toArray() : source[key].value);
            }
            return this;
        }

        setParameter(parameter, value) {
            const key = parameter.uniform;
            if (value.isNode || !this[key].isUniformNode) {
                this[key] = value.isNode ? value : this.uniformOf(value);
                this.needsUpdate = true;
            } else if (Array.isArray(value)) this[key].value.set(...value);
            else this[key].value = value;
        }

        // What a mirror would show of the scene's environment is not drawn; its light is.
        setupEnvironment(builder) {
            const around = super.setupEnvironment(builder) ?? builder.environmentNode;
            return around ? new THREE.EnvironmentNode(around) : null;
        }

        setupLightingModel() {
            return new MotesLightingModel();
        }
    };
}
