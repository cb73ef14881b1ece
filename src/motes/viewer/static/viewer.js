function Ee(i,e={},...t){let n=document.createElement(i);return Bf(n,e,t),n}function dt(i,e={},...t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);return Bf(n,e,t),n}function Bf(i,e,t){for(let[n,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?i.addEventListener(n.slice(2),s):i.setAttribute(n,s===!0?"":String(s)));i.append(...t.filter(n=>n!=null))}function kf(i){let[e,t]=i.split("_");return Ee("i",{class:"motes-symbol"},e??"",t?Ee("sub",{},t):null)}var Of=0;function Ii(i){return Of+=1,`motes-${i}-${Of}`}function ht(i,e=4){return Number.isFinite(i)?i!==0&&(Math.abs(i)<.001||Math.abs(i)>=1e5)?i.toExponential(2):String(Number(i.toPrecision(Math.abs(i)<.01?Math.min(e,3):e))):"not a number"}var Fn=(i,e,t)=>Math.min(Math.max(i,e),t),fi=i=>i*180/Math.PI,Qt=i=>i*Math.PI/180;var[Qg,e0]=[360,210],Wt={left:52,right:10,top:10,bottom:34},As=class{constructor(e,t=e0,n=Qg){this.height=t;this.width=n;this.title=dt("title",{},e);let s=dt("rect",{x:Wt.left,y:Wt.top-4,width:n-Wt.left-Wt.right,height:t-Wt.top-Wt.bottom+8});this.svg=dt("svg",{viewBox:`0 0 ${n} ${t}`,role:"img",class:"motes-chart"},this.title,dt("defs",{},dt("clipPath",{id:this.clip},s)),this.body)}height;width;svg;title;body=dt("g");x={low:0,high:1,label:""};y={low:0,high:1,label:""};clip=Ii("clip");begin(e,t,n){this.title.textContent=e,this.body.replaceChildren(),this.x=t,this.y=n.high>n.low?n:{...n,high:n.low+1};let s=this.height-Wt.bottom;for(let r of t.ticks??va(t.low,t.high,this.width>300?6:4)){let o=this.px(r);this.body.append(dt("line",{x1:o,x2:o,y1:Wt.top,y2:s,class:"grid"}),dt("text",{x:o,y:s+14,class:"tick","text-anchor":"middle"},(t.write??ht)(r)))}for(let r of this.y.ticks??va(this.y.low,this.y.high,4)){let o=this.py(r);this.body.append(dt("line",{x1:Wt.left,x2:this.width-Wt.right,y1:o,y2:o,class:r===0?"axis":"grid"}),dt("text",{x:Wt.left-5,y:o+3.5,class:"tick","text-anchor":"end"},(this.y.write??ht)(r)))}this.body.append(dt("text",{x:(Wt.left+this.width-Wt.right)/2,y:this.height-4,class:"label","text-anchor":"middle"},t.label),dt("text",{x:10,y:(Wt.top+s)/2,class:"label","text-anchor":"middle",transform:`rotate(-90 10 ${(Wt.top+s)/2})`},n.label))}line({x:e,y:t,tint:n,dashed:s}){let r="",o="M";for(let a=0;a<e.length;a+=1){if(!Number.isFinite(t[a])){o="M";continue}r+=`${o}${this.px(e[a]).toFixed(1)} ${this.py(t[a]).toFixed(1)}`,o="L"}this.inside(dt("path",{d:r,class:`line ${n}${s?" dashed":""}`}))}band(e,t,n,s){let r=[];for(let o=0;o<e.length;o+=1)r.push(`${this.px(e[o]).toFixed(1)} ${this.py(n[o]).toFixed(1)}`);for(let o=e.length-1;o>=0;o-=1)r.push(`${this.px(e[o]).toFixed(1)} ${this.py(t[o]).toFixed(1)}`);r.length&&this.inside(dt("path",{d:`M${r.join("L")}Z`,class:`band ${s}`}))}dots(e,t,n){let s="";for(let r=0;r<e.length;r+=1)Number.isFinite(t[r])&&(s+=`M${this.px(e[r]).toFixed(1)} ${this.py(t[r]).toFixed(1)}h0`);s&&this.inside(dt("path",{d:s,class:`dots ${n}`}))}bars(e,t,n,s){let r="";for(let o=0;o<e.length;o+=1)Number.isFinite(t[o])&&Number.isFinite(n[o])&&(r+=`M${this.px(e[o]).toFixed(1)} ${this.py(t[o]).toFixed(1)}V${this.py(n[o]).toFixed(1)}`);r&&this.inside(dt("path",{d:r,class:`bars ${s}`}))}mark(e){this.inside(dt("line",{x1:this.px(e),x2:this.px(e),y1:Wt.top,y2:this.height-Wt.bottom,class:"now"}))}inside(e){e.setAttribute("clip-path",`url(#${this.clip})`),this.body.append(e)}px(e){return Wt.left+(e-this.x.low)/(this.x.high-this.x.low)*(this.width-Wt.left-Wt.right)}py(e){let t=this.height-Wt.bottom;return t-(e-this.y.low)/(this.y.high-this.y.low)*(t-Wt.top)}};function va(i,e,t){let n=(e-i)/t;if(!(n>0)||!Number.isFinite(n))return[i];let s=10**Math.floor(Math.log10(n)),r=[1,2,2.5,5,10].map(a=>a*s).find(a=>a>=n*.999),o=[];for(let a=Math.ceil(i/r-1e-9);a*r<=e+1e-9*r;a+=1)o.push(Number((a*r).toPrecision(10)));return o}var Pi=class{constructor(e,t){this.options=e;let n=Ii("slider"),{low:s,high:r,label:o,unit:a,hint:l}=e,c=e.step??(r-s)/500,h=`${o}${a?`, ${a}`:""}`;this.range=Ee("input",{type:"range",id:n,min:s,max:r,step:"any",class:`motes-range ${e.tint??""}`,title:l,"aria-label":h}),this.number=Ee("input",{type:"number",step:Number(c.toPrecision(1)),class:"motes-number","aria-label":`${h}: number`});let u=p=>{try{e.set(p)}catch(g){t(g),this.show(this.shown,void 0,!0)}};if(this.range.addEventListener("input",()=>u(Number(this.range.value))),this.range.addEventListener("keydown",p=>{let g={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[p.key];if(g===void 0)return;p.preventDefault();let y=(r-s)/100;u(Math.min(Math.max(Number(this.range.value)+g*(e.step??y),s),r))}),this.number.addEventListener("change",()=>u(this.number.value===""?NaN:Number(this.number.value))),e.reset){let p=e.reset;this.button=Ee("button",{type:"button",class:"motes-reset",title:e.resetLabel??"Reset","aria-label":`Reset ${o}`,onclick:()=>p()},"↺")}let f=Ee("label",{for:n,title:l},e.symbol?kf(e.symbol):null,e.symbol?" ":null,Ee("span",{},e.shown??o),a?Ee("span",{class:"motes-unit"},` ${a}`):null);this.element=Ee("div",{class:"motes-slider"},f,this.range,this.number,this.button)}options;element;range;number;button=null;shown=NaN;show(e,t,n=!1){(e!==this.shown||n)&&(this.shown=e,this.range.value=String(e),this.number.value=ht(e),this.range.setAttribute("aria-valuetext",`${ht(e)}${this.options.unit?` ${this.options.unit}`:""}`)),t!==void 0&&this.button&&(this.button.disabled=!t)}},Li=class{element;select;constructor(e,t,n){let s=Ii("choice");this.select=Ee("select",{id:s,onchange:()=>n(this.select.value)}),this.fill(t),this.element=Ee("div",{class:"motes-choice"},Ee("label",{for:s},e),this.select)}fill(e){let t=this.select.value;this.select.replaceChildren(...e.map(([n,s])=>Ee("option",{value:n},s))),this.show(t)}show(e){Array.from(this.select.options).some(t=>t.value===e)&&(this.select.value=e)}},_a=class{element;box;constructor(e,t,n){this.box=Ee("input",{type:"checkbox",onchange:()=>t(this.box.checked)}),this.element=Ee("label",{class:"motes-switch",title:n},this.box," ",e)}show(e){this.box.checked=e}};function $n(i,e,t={}){return Ee("button",{type:"button",...t,onclick:()=>e()},i)}function di(i,e,...t){return Ee("details",{class:"motes-section",open:e},Ee("summary",{},Ee("h2",{},i)),Ee("div",{class:"motes-body"},...t))}var oe=class extends Error{constructor(t,n=""){super(t);this.hint=n;this.name="Problem"}hint};function Ut(i){let e=typeof i=="string"?i:JSON.stringify(i)??String(i);return e.length>60?`${e.slice(0,57)}...`:e}function Ni(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n+=1)t[n]=e.charCodeAt(n);return t.buffer}var zf="motes material";var xn={lambert:{brdf:!0,summary:"A matte surface that looks equally bright from everywhere; its directional albedo is ``K_d``.",fields:[{kind:"parameter",name:"K_d",symbol:"K_d",unit:"",meaning:"diffuse reflectance",value:.5,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:""}]},oren_nayar:{brdf:!0,summary:"V-shaped grooves of Lambertian facets: plaster, clay, cloth, the dry side of paint.",fields:[{kind:"parameter",name:"K_d",symbol:"K_d",unit:"",meaning:"diffuse reflectance of a facet",value:.5,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:""},{kind:"parameter",name:"sigma_d",symbol:"σ_d",unit:"rad",meaning:"standard deviation of the facets' slope angle",value:.3,low:0,high:1.5707963267948966,open:!1,typical:[0,1.5707963267948966],perChannel:!1,role:"diffuse_roughness",advice:""}]},eon:{brdf:!0,summary:"A rough diffuse surface that loses no light: with rho = 1 it reflects all of it at every roughness and angle.",fields:[{kind:"parameter",name:"rho",symbol:"\\rho",unit:"",meaning:"colour that the surface has after one reflection; 1 loses no light",value:.5,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:"EON is an albedo: scale radiances to at most 1, or take oren_nayar, which allows any K_d"},{kind:"parameter",name:"r",symbol:"r",unit:"",meaning:"roughness of the diffuse part; 0 is Lambert",value:.3,low:0,high:1,open:!1,typical:[0,1],perChannel:!1,role:"diffuse_roughness",advice:""}]},torrance_sparrow:{brdf:!0,summary:"Mirror-like facets whose tilt theta_h is distributed as exp(-(theta_h/sigma_s)^2).",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"strength of the highlight",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"sigma_s",symbol:"σ_s",unit:"rad",meaning:"width of the distribution of facet normals",value:.15,low:.001,high:1.5707963267948966,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"option",name:"normalization",value:"printed",words:["printed","facets"]},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null}]},ggx:{brdf:!0,summary:"Mirror-like facets with the long tails of ground glass: most polished, lacquered and metallic surfaces, better than Gaussian ones.",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"share of light that facets reflect, or its factor where there is a Fresnel term",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"alpha",symbol:"\\alpha",unit:"",meaning:"roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",value:.2,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},beckmann:{brdf:!0,summary:"Mirror-like facets whose slopes are Gaussian: the highlight falls off faster than that of `GGX`.",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"share of light that facets reflect, or its factor where there is a Fresnel term",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"alpha",symbol:"\\alpha",unit:"",meaning:"roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",value:.2,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},gtr:{brdf:!0,summary:"Mirror-like facets with a tail that the data choose: enamel, metallic paint, worn metal.",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"share of light that facets reflect, or its factor where there is a Fresnel term",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"alpha",symbol:"\\alpha",unit:"",meaning:"roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",value:.2,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"parameter",name:"gamma",symbol:"\\gamma",unit:"",meaning:"exponent of the tail of the highlight: 2 is GGX, 1 the longest",value:2,low:1,high:10,open:!1,typical:[1,4],perChannel:!1,role:"highlight_tail",advice:""},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null}]},dust:{brdf:!0,summary:"An opaque bed of small particles that scatter once.",fields:[{kind:"parameter",name:"w",symbol:"w",unit:"",meaning:"single-scattering albedo of the dust",value:.6,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"single_scattering_albedo",advice:""},{kind:"parameter",name:"g",symbol:"g",unit:"",meaning:"mean cosine of the deviation angle",value:0,low:-1,high:1,open:!0,typical:[-.8,.8],perChannel:!1,role:"asymmetry",advice:"g > 0 scatters forward, g < 0 backward, 0 evenly"},{kind:"option",name:"form",value:"brdf",words:["brdf","brightness"]},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},dust_layer:{brdf:!0,summary:"A layer of dust of optical thickness ``tau`` over a base (Blinn 1982).",fields:[{kind:"child",name:"base",accepts:"brdf",place:"base",required:!0,value:null},{kind:"child",name:"dust",accepts:"dust",place:"cover",required:!1,value:"dust"},{kind:"parameter",name:"tau",symbol:"τ",unit:"",meaning:"optical thickness of the layer",value:.2,low:0,high:null,open:!1,typical:[0,2],perChannel:!1,role:"depth",advice:""},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},coated_diffuse:{brdf:!0,summary:"What comes back from below a gloss: paint, varnished wood, plastic, glazed clay. Its highlight is another model: ``+ GGX(...)``.",fields:[{kind:"parameter",name:"rho",symbol:"\\rho",unit:"",meaning:"diffuse reflectance of the body, as seen from inside",value:.5,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:"It is an albedo: scale radiances to at most 1, or take lambert, which allows any K_d"},{kind:"parameter",name:"n",symbol:"n",unit:"",meaning:"refractive index of the body relative to the outside",value:1.5,low:1,high:4,open:!1,typical:[1.2,2],perChannel:!1,role:"refractive_index",advice:"Water 1.33, glass and varnish 1.5, diamond 2.4"}]},hapke:{brdf:!0,summary:"An opaque bed of particles: powders, soil, pigments, the surfaces of the Moon and of asteroids.",fields:[{kind:"parameter",name:"w",symbol:"w",unit:"",meaning:"single-scattering albedo of the particles",value:.6,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"single_scattering_albedo",advice:""},{kind:"parameter",name:"g",symbol:"g",unit:"",meaning:"mean cosine of the deviation angle",value:-.2,low:-1,high:1,open:!0,typical:[-.6,.6],perChannel:!1,role:"asymmetry",advice:"g > 0 scatters forward, g < 0 backward, 0 evenly"},{kind:"parameter",name:"B_0",symbol:"B_0",unit:"",meaning:"height of the opposition surge, of what particles scatter back",value:.5,low:0,high:1,open:!1,typical:[0,1],perChannel:!1,role:"surge_strength",advice:""},{kind:"parameter",name:"h",symbol:"h",unit:"",meaning:"angular half width of the opposition surge, tan of half the angle between light and viewer",value:.06,low:.001,high:1,open:!1,typical:[.01,.3],perChannel:!1,role:"surge_width",advice:""}]},retro:{brdf:!0,summary:"Light that goes back to where it came from: a term beside others, ``EON(...) + Retro(...)``, for cloth, road signs and rough minerals.",fields:[{kind:"parameter",name:"K_r",symbol:"K_r",unit:"",meaning:"share of light that is sent back",value:.1,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"further_strength",advice:""},{kind:"parameter",name:"alpha_r",symbol:"\\alpha_r",unit:"",meaning:"width of what is sent back, the roughness alpha of the GGX that would mirror it",value:.3,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"further_width",advice:""}]},sheen:{brdf:!0,summary:"What velvet, felt and downy surfaces add towards grazing, where they are brightest: a term beside others, ``EON(...) + Sheen(...)``.",fields:[{kind:"parameter",name:"K_f",symbol:"K_f",unit:"",meaning:"strength of the fibres; with 1 they return at most as much light as arrives",value:.2,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"further_strength",advice:""},{kind:"parameter",name:"a",symbol:"a",unit:"",meaning:"roughness of the fibres: small where they stand upright and shine at grazing angles alone",value:.5,low:.22,high:1,open:!1,typical:[.22,1],perChannel:!1,role:"further_width",advice:"Other programs allow less, with more light than arrives"}]},dielectric:{brdf:!1,summary:"Glass, varnish, plastic, water: a real refractive index; exact.",fields:[{kind:"parameter",name:"n",symbol:"n",unit:"",meaning:"refractive index relative to the outside",value:1.5,low:1,high:10,open:!1,typical:[1.02,4],perChannel:!0,role:"refractive_index",advice:"Water 1.33, glass and varnish 1.5, diamond 2.4"}]},conductor:{brdf:!1,summary:"Metals: a complex refractive index n + ik; exact.",fields:[{kind:"parameter",name:"n",symbol:"n",unit:"",meaning:"real part of the refractive index",value:1,low:.01,high:20,open:!1,typical:[.05,10],perChannel:!0,role:"refractive_index",advice:""},{kind:"parameter",name:"k",symbol:"k",unit:"",meaning:"extinction coefficient",value:3,low:0,high:30,open:!1,typical:[0,15],perChannel:!0,role:"extinction",advice:""}]},schlick:{brdf:!1,summary:"Schlick's approximation from the reflectance at normal incidence: one parameter, good for a fit.",fields:[{kind:"parameter",name:"f0",symbol:"f_0",unit:"",meaning:"reflectance at normal incidence",value:.04,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"normal_reflectance",advice:""}]}};var ya=/\s*([A-Za-z_]\w*|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|'[^']*'|"[^"]*"|[()[\],=+])/y,Hf=64,Gf=2e4;function Wf(i){Object.assign(xn,i)}function xa(i){let e=xn[i]?.fields.find(t=>t.kind==="child"&&t.place==="base");return e?.kind==="child"?e:null}function Qc(i){if(i.length>Gf)throw new oe(`The model's text has ${i.length} characters`,`It may have ${Gf}`);let e=t0(i),t=0,n=0,s=()=>{throw new oe(`The model ${Ut(i)} is not a sum of models`,`The models are ${Object.keys(xn).join(", ")}`)},r=()=>e[t],o=g=>{let y=e[t];return y===void 0||g!==void 0&&y!==g?s():(t+=1,y)},a=()=>{let g=l();for(;r()==="+";)o(),g={kind:"sum",a:g,b:l()};return g},l=()=>{if(r()==="("){o();let g=a();return o(")"),g}return c(o())},c=g=>{let y=Object.hasOwn(xn,g)?xn[g]:void 0;if(!y)throw new oe(`${Ut(g)} is not a model`,`The models are ${Object.keys(xn).join(", ")}`);if(n+=1,n>Hf)throw new oe(`The model has more than ${Hf} parts`,"Write a shorter one");let m=$f(g),v=new Map(y.fields.map(w=>[w.name,w]));if(r()!=="(")return Vf(m);o("(");let A=y.fields.filter(w=>w.kind==="child"&&w.place!=="fresnel"),S=new Set;for(;r()!==")";){let w=/^[A-Za-z_]/.test(r()??"")&&e[t+1]==="="?o():A[S.size]?.name??s();r()==="="&&o();let T=v.get(w);if(!T||S.has(w))throw new oe(`${g} has no ${Ut(w)} (or it is given twice)`,`It has ${[...v.keys()].join(", ")}`);S.add(w),T.kind==="parameter"?m.values[w]=h():T.kind==="option"?m.options[w]=f(T.words,`${g}: ${w}`):m.children[w]=n0(T,a(),g),r()!==")"&&o(",")}return o(")"),Vf(m)},h=()=>{if(!(r()==="["||r()==="("))return[u(o())];o();let y=[u(o())];for(;r()===",";)o(),y.push(u(o()));return o(),y},u=g=>Number.isFinite(Number(g))?Number(g):s(),f=(g,y)=>{let m=o().replace(/^['"]|['"]$/g,"");if(!g.includes(m))throw new oe(`${y} = ${Ut(m)} is not one of ${g.join(", ")}`,"Correct the model");return m},p=a();if(t<e.length&&s(),p.kind==="named"&&!xn[p.name]?.brdf)throw new oe(`${p.name} is a Fresnel term, not a BRDF`,"Use it as torrance_sparrow(fresnel=...)");return p}function $f(i){let e={kind:"named",name:i,options:{},children:{},values:{}};for(let t of xn[i].fields)t.kind==="option"&&(e.options[t.name]=t.value),t.kind==="child"&&(e.children[t.name]=t.value?$f(t.value):null),t.kind==="parameter"&&(e.values[t.name]=[t.value]);return e}function t0(i){let e=[];ya.lastIndex=0;let t=i.trimEnd();for(;ya.lastIndex<t.length;){let n=ya.lastIndex,s=ya.exec(t);if(!s)throw new oe(`The model ${Ut(i)} cannot be read from ${Ut(i.slice(n,n+20))} on`,"Write for example oren_nayar + torrance_sparrow");e.push(s[1])}return e}function n0(i,e,t){let n=i.accepts==="brdf"||i.accepts==="fresnel";if(!(e.kind==="sum"?i.accepts==="brdf":n?i.accepts==="brdf"===xn[e.name]?.brdf:i.accepts===e.name))throw new oe(`${t}: ${i.name} is not a ${i.accepts}`,"Correct the model");return e}function Vf(i){for(let e of xn[i.name].fields){if(e.kind!=="child")continue;let t=i.children[e.name];if(e.required&&!t)throw new oe(`${i.name} has no ${e.name}`,`Write ${i.name}(oren_nayar), say`);if(!(e.place!=="cover"||t?.kind!=="named")){for(let n of xn[t.name].fields)if(n.kind==="option"&&t.options[n.name]!==n.value)throw new oe(`The ${e.name} of ${i.name} must have the ${n.name} ${n.value}`,`Leave its ${n.name} out`)}}return i}function eh(i){let e=new Map,t=[],n=s=>{if(s.kind==="sum"){n(s.a),n(s.b);return}for(let r of xn[s.name].fields)if(r.kind==="parameter"){let o=(e.get(r.name)??0)+1;e.set(r.name,o),t.push({name:o===1?r.name:`${r.name}_${o}`,declared:r,value:s.values[r.name]})}else if(r.kind==="child"){let o=s.children[r.name];o&&n(o)}};return n(i),t}var ba="motes_eval";function qf(i,e,t,n){let s=new Set,r=0,o=g=>{let y=t[g];if(!y)throw new oe(`This page holds no shader for ${g}`,"Write a page of its own: motes view MATERIAL");return s.add(g),y},a=g=>{let y=e[r];return r+=1,g>1&&y.value.length===1?`vec3(${y.name})`:y.name},l=(g,y)=>{let m=o(g),v=m.uniforms.slice(y.length).map(A=>a(A.size));return`${m.name}_with(wi, wo, ${[...y,...v].join(", ")})`},c=g=>{if(g.kind==="sum")return`(${c(g.a)} + ${c(g.b)})`;let y=xa(g.name);if(!y)return l(Xf(g),[]);let m=c(g.children[y.name]);return l(Xf(g),[`3.14159265358979 * ${m}`])},h=c(i),u=e.map(g=>({name:`motes_${g.name}`,slot:g.name,size:g.value.length})),f=g=>g===1?"float":"vec3";return{source:[`// ${n.replace(/[^ -~]|\\|\*\//g," ")}`,"// Put together by the viewer from shaders that Motes printed from its equations, one for each model.","",...[...s].map(g=>t[g].source),...u.map(g=>`uniform ${f(g.size)} ${g.name};`),"",`vec3 ${ba}_with(vec3 wi, vec3 wo${e.map(g=>`, ${f(g.value.length)} ${g.name}`).join("")}) {`,`    return ${h};`,"}","",`vec3 ${ba}(vec3 wi, vec3 wo) {`,`    return ${ba}_with(wi, wo${u.map(g=>`, ${g.name}`).join("")});`,"}",""].join(`
`),name:ba,uniforms:u,channels:Math.max(...e.map(g=>g.value.length)),stages:!1,kept:[],table:null}}function Xf(i){let e=xn[i.name].fields.flatMap(t=>{if(t.kind==="option")return[i.options[t.name]];let n=t.kind==="child"&&t.place==="fresnel"?i.children[t.name]:null;return n&&n.kind==="named"?[n.name]:[]});return[i.name,...e].join("_")}var i0=200;function th(i){let e=Qc(i.json.model),t=eh(e);for(let s of t)s.value=nh(i.json.parameters[s.name]?.value,s.name),s.declared={...s.declared,...i.ranges[s.name]};if(i.shader.uniforms.map(s=>s.slot).join()!==t.map(s=>s.name).join())throw new oe("The shader and the model of this page disagree","Write the page again with motes view");for(let[s,r]of i.shader.uniforms.entries())t[s].value=ih(t[s].value,r.size);return Kf(i.json,e,t,i.shader,i.time,i.to_srgb,i.color,!1)}function Zf(i,e){if(!ln(i)||i.format!==zf)throw new oe(`This JSON is not a Motes material: its format is ${Ut(ln(i)?i.format:i)}`,"motes fit DATA -o OUT writes one");let t=i.version;if(typeof t!="number"||!Number.isInteger(t)||t>1)throw new oe(`The material's version ${Ut(t)} is newer than ${1}, which this page reads`,"Write the page again with a newer Motes");let n=Qc(String(i.model)),s=eh(n),r=ln(i.parameters)?i.parameters:{};for(let g of Object.keys(r))if(!s.some(y=>y.name===g))throw new oe(`The model ${Ut(i.model)} has no parameter ${Ut(g)}`,`It has ${s.map(y=>y.name).join(", ")}`);for(let g of s){let y=r[g.name];if(!ln(y))throw new oe(`The material has no value for ${g.name}`,"Write it again with motes fit");g.value=nh(y.value,g.name);for(let m of g.value)Ma(g,m);if(g.value.length>1&&!g.declared.perChannel)throw new oe(`${g.name} has ${g.value.length} values; it is one for all channels`,"Correct the material")}let o=Math.max(...s.map(g=>g.value.length));if(o!==1&&o!==3)throw new oe(`The material has ${o} channels; one or three can be dropped onto a page`,"motes view MATERIAL writes a page for any number");for(let g of s)if(g.value.length!==1&&g.value.length!==o)throw new oe(`${g.name} has ${g.value.length} values and the material ${o} channels`,"Correct the material");let a=String(i.name??"material").slice(0,i0),l=Array.isArray(i.channels)&&i.channels.length===o?i.channels.map(String):o===3?["R","G","B"]:["grey"],c=o===1?[[1,1,1]]:[[1,0,0],[0,1,0],[0,0,1]],h=[],u=s0(i.trends,s,a,h),f={...i,name:a,channels:l},p=o===3?"the three channels are shown as linear sRGB":"shown in grey";return{material:Kf(f,n,s,qf(n,s,e,a),u,c,p,!0),notes:h}}function Kf(i,e,t,n,s,r,o,a){let c=(e.kind==="named"&&xa(e.name)?t.filter(h=>h.declared.role==="depth"):[]).at(-1)?.name??null;return{name:i.name,model:e,slots:t,shader:n,time:s,toSrgb:r,color:o,channels:i.channels,wavelengths:i.wavelengths_nm??[],json:i,tau:c,dropped:a}}function s0(i,e,t,n){if(!ln(i)||!Object.keys(i).length)return null;let s=Object.entries(i).flatMap(([l,c])=>{let h=ln(c)&&c.kind==="tabulated"?c:null,u=h&&Array.isArray(h.hours)?h.hours.map(Number):[],f=h&&Array.isArray(h.values)?h.values.map(y=>nh(y,l)):[],p=e.find(y=>y.name===l)?.value.length;return u.length>1&&u.length===f.length&&u.every((y,m)=>Number.isFinite(y)&&(m===0||y>u[m-1]))&&f.every(y=>y.length===p||y.length===1)&&p?[{slot:l,hours:u,values:f.map(y=>ih(y,p))}]:[]});if(s.length<Object.keys(i).length&&n.push(`${t} follows time; a dropped material shows its first moment, for the formulas of its trends are in Python: motes view MATERIAL writes a page that plays it.`),s.length<Object.keys(i).length||!s.length)return null;let r=[Math.min(...s.map(l=>l.hours[0])),Math.max(...s.map(l=>l.hours.at(-1)))],o=[...new Set(s.flatMap(l=>l.hours))].sort((l,c)=>l-c),a=l=>o.map(c=>Jf(l.hours,l.values,c));return{hours:o,interval:r,trends:Object.fromEntries(s.map(l=>[l.slot,{kind:"tabulated",values:a(l),stderr:null,scans:null}]))}}function Jf(i,e,t){if(t<=i[0])return e[0];if(t>=i.at(-1))return e.at(-1);let n=0,s=i.length-1;for(;s-n>1;){let o=n+s>>1;i[o]<=t?n=o:s=o}let r=(t-i[n])/(i[s]-i[n]);return e[n].map((o,a)=>o+r*(e[s][a]-o))}function jf(i,e){let t=n=>Object.hasOwn(e,n.name)&&e[n.name].length===n.value.length&&e[n.name].every(s=>td(n,s));return Object.fromEntries(i.slots.filter(t).map(n=>[n.name,e[n.name]]))}function Qf(i,e,t){let n={};for(let s of i.slots){let r=i.time?.trends[s.name],o=r&&e!==null?ih(Jf(i.time.hours,r.values,e),s.value.length):s.value;n[s.name]=t[s.name]??o}return n}function ed(i,e,t,n){let s=Object.fromEntries(i.slots.map(l=>{let c=e[l.name],h=c.length===1&&!Array.isArray(i.json.parameters[l.name]?.value);return[l.name,{value:h?c[0]:c,unit:l.declared.unit,meaning:l.declared.meaning}]})),r=Object.fromEntries(Object.entries(i.json.trends??{}).filter(([l])=>!(l in t))),o=Object.keys(t),a={...i.json.about,...o.length?{viewer:`set by hand: ${o.join(", ")}`}:{},...Object.keys(r).length&&n!==null?{viewer_hours:n}:{}};return{...i.json,parameters:s,trends:r,about:a}}function td(i,e){let{low:t,high:n,open:s}=i.declared,r=n??1/0;return Number.isFinite(e)&&(s?e>t&&e<r:e>=t&&e<=r)}function Ma(i,e){if(td(i,e))return;let{low:t,high:n,open:s,unit:r,meaning:o,advice:a}=i.declared,l=`${s?"(":"["}${t}, ${n===null?"inf)":`${Number(n.toFixed(4))}${s?")":"]"}`}${r?` ${r}`:""}`;throw new oe(`${i.name} = ${e} is outside ${l} (${o})`,a||(r==="rad"?"Angles are in radians":`Choose a value in ${l}`))}function nh(i,e){let t=Array.isArray(i)?i.flat(4):[i];if(!t.length||!t.every(n=>typeof n=="number"&&Number.isFinite(n)))throw new oe(`${e} = ${Ut(i)} is not a number or a list of numbers`,"Correct the material");return t}var ih=(i,e)=>i.length===1&&e>1?Array(e).fill(i[0]):i,ln=i=>typeof i=="object"&&i!==null&&!Array.isArray(i);var $t={azimuth:{low:-180,high:180},elevation:{low:-89,high:89},distance:{low:1.5,high:30},lampAzimuth:{low:-180,high:180},lampElevation:{low:-30,high:90},lamp:{low:0,high:4},sky:{low:0,high:4},exposure:{low:-6,high:6},split:{low:.05,high:.95},incidence:{low:0,high:88},hours:{low:-1e9,high:1e9},active:{low:0,high:1}},r0={up:["y","z"],environment:["sky","studio","dome","none","own"],tone:["neutral","agx","clip"],compare:["one","side","split"],radius:["f","f cos"],scale:["linear","cube root"]};function nd(i,e,t){return{values:[{},{}],dropped:[null,null],active:0,hours:e,shape:i,azimuth:0,elevation:12,distance:5.2,lampAzimuth:-45,lampElevation:40,lamp:.9,environment:"studio",sky:.8,exposure:0,tone:"neutral",compare:t?"split":"one",split:.5,dust:!0,lobe:!0,backdrop:!1,ground:!0,up:"y",incidence:45,radius:"f",scale:"linear"}}var o0=100;function id(i,e){let t=Object.fromEntries(Object.entries(i).filter(([s,r])=>JSON.stringify(r)!==JSON.stringify(e[s])));if(!Object.keys(t).length)return"";let n=new TextEncoder().encode(JSON.stringify(t));return`#motes=${btoa(Array.from(n,s=>String.fromCharCode(s)).join("")).replace(/\+/g,"-").replace(/\//g,"_").replace(/=+$/,"")}`}function sd(i,e){let t=/^#motes=([\w-]+)$/.exec(i);if(!t)return null;try{let n=atob(t[1].replace(/-/g,"+").replace(/_/g,"/")),s=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(Uint8Array.from(n,r=>r.charCodeAt(0))));return ln(s)?sh(e,s):null}catch{return null}}function sh(i,e){let t=structuredClone(i),n=t;for(let[s,r]of Object.entries($t))typeof e[s]=="number"&&Number.isFinite(e[s])&&(n[s]=Fn(e[s],r.low,r.high));for(let[s,r]of Object.entries(r0))typeof e[s]=="string"&&r.includes(e[s])&&(n[s]=e[s]);for(let s of["dust","lobe","backdrop","ground"])typeof e[s]=="boolean"&&(n[s]=e[s]);typeof e.shape=="string"&&(t.shape=e.shape.slice(0,o0)),t.active=Math.round(t.active);for(let s of[0,1]){let r=Array.isArray(e.values)?e.values[s]:null;if(ln(r)){t.values[s]={};for(let[a,l]of Object.entries(r))Array.isArray(l)&&l.every(c=>typeof c=="number"&&Number.isFinite(c))&&(t.values[s][a]=l)}let o=Array.isArray(e.dropped)?e.dropped[s]:null;ln(o)&&(t.dropped[s]=o)}return t}var Sa=class{constructor(e){this.state=e}state;listeners=new Set;listen(e){this.listeners.add(e)}change(e){let t=Object.keys(e).filter(s=>JSON.stringify(e[s])!==JSON.stringify(this.state[s]));if(!t.length)return;this.state={...this.state,...e};let n=new Set(t);for(let s of this.listeners)s(n)}hold(e,t,n){let s=[{...this.state.values[0]},{...this.state.values[1]}],r=s[e];n?r[t]=n:delete r[t],this.change({values:s})}};var Zt={angles:{phase:["phase","phase_angle"],theta_i:["theta_i","inc","theta_in","theta_inc","theta_incident","theta_incidence","theta_l","theta_light","theta_source","theta_sun","theta_illumination","i_theta","in_theta","incidence_angle","incident_angle","angle_of_incidence","aoi","incidence","incident_theta","incident_zenith","incidence_zenith","illumination_zenith","illumination_angle","light_zenith","light_theta","light_angle","source_zenith","source_angle","lamp_zenith","lamp_angle","sun_zenith","solar_zenith","solar_zenith_angle","sun_zenith_angle","sza","zenith_i","zenith_in","polar_i","polar_in"],phi_i:["phi_i","phi_in","phi_inc","phi_incident","phi_incidence","phi_l","phi_light","phi_source","phi_sun","i_phi","in_phi","incidence_azimuth","incident_azimuth","incident_phi","illumination_azimuth","light_azimuth","light_phi","source_azimuth","lamp_azimuth","sun_azimuth","solar_azimuth","solar_azimuth_angle","sun_azimuth_angle","saa","azimuth_i","azimuth_in"],theta_r:["theta_r","theta_o","theta_out","theta_e","theta_refl","theta_reflected","theta_v","theta_view","theta_viewer","theta_viewing","theta_scatter","theta_scattered","theta_detector","theta_camera","theta_sensor","r_theta","o_theta","out_theta","reflection_angle","reflected_angle","scatter_angle","scattering_angle","exit_angle","emi","emission","emission_angle","emergence","emergence_angle","detector_angle","view_angle","viewing_angle","view_zenith","viewing_zenith","view_theta","view_zenith_angle","viewing_zenith_angle","vza","sensor_zenith","detector_zenith","camera_zenith","reflected_zenith","scatter_zenith","outgoing_theta","outgoing_zenith","zenith_r","zenith_o","zenith_out","polar_r","polar_o","polar_out"],phi_r:["phi_r","phi_o","phi_out","phi_e","phi_refl","phi_reflected","phi_v","phi_view","phi_viewer","phi_viewing","phi_scatter","phi_scattered","phi_detector","phi_camera","phi_sensor","phi_s","r_phi","o_phi","out_phi","reflected_azimuth","scatter_azimuth","view_azimuth","viewing_azimuth","view_phi","view_azimuth_angle","viewing_azimuth_angle","vaa","sensor_azimuth","detector_azimuth","camera_azimuth","outgoing_phi","outgoing_azimuth","azimuth_r","azimuth_o","azimuth_out","phi","azimuth","dphi","delta_phi","phi_diff","relative_azimuth","relative_azimuth_angle","azimuth_difference","raa"],theta_s:["theta_s"],theta_h:["theta_h","theta_half"],theta_d:["theta_d","theta_diff","theta_difference"],phi_d:["phi_d","phi_difference"],phi_h:["phi_h","phi_half"]},vectors:{wi_x:["wi_x","light_x","l_x"],wi_y:["wi_y","light_y","l_y"],wi_z:["wi_z","light_z","l_z"],wo_x:["wo_x","wr_x","view_x","v_x"],wo_y:["wo_y","wr_y","view_y","v_y"],wo_z:["wo_z","wr_z","view_z","v_z"]},times:{"":["time","elapsed","elapsed_time","age","timestamp","datetime","date"],"with unit":["t"],s:["seconds","second","secs","sec"],min:["minutes","minute","mins"],h:["hours","hour","hrs","hr"],d:["days","day"],week:["weeks","week"],a:["years","year"]},others:{scan:["scan","scan_number","scan_no","scan_index","frame"],weight:["weight","weights","solid_angle"],wavelength:["wavelength","wavelengths","lambda","wl","wvl","wave"],channel:["channel","band","color","colour","filter","primary"]},values:{brdf:["brdf","f_r","f","bsdf","brdf_value","bsdf_value","value","brdf_mean","mean_brdf","mean"],brdf_cos_r:["brdf_cos_r","brdf_cos_theta_r","f_r_cos_theta_r","f_cos_theta_r","ccbrdf","ccbsdf","cosine_corrected_brdf","cosine_corrected_bsdf"],brdf_cos_i:["brdf_cos_i","brdf_cos_theta_i","f_r_cos_theta_i","f_cos_theta_i"],reflectance_factor:["reflectance_factor","brf","hcrf","hdrf","brrf","bidirectional_reflectance_factor","radiance_factor","radiance_coefficient"]},channels:{R:["r","red"],G:["g","green"],B:["b","blue"],grey:["grey","gray","mono","white","luminance","lum","photopic"],NIR:["nir","ir","near_infrared","infrared"],SWIR:["swir"],VIS:["vis","visible"],UV:["uv"],cyan:["cyan"],magenta:["magenta"],yellow:["yellow"]},uncertainty:{signs:["±","+/-","+-"],words:["unc","uncert","uncertainty","uncertainties","sigma","std","stdev","stddev","sd","err","error","stderr","se","standarddeviation"],first:["u","delta"],relative:["rel","relative"],expanded:["expanded","k2","u95","ci95"],passed_over:["of","in","the","abs","absolute","standard","total","combined"]},index:["index","id","row","row_id","row_number","rownames","row_names","no","nr","number","point","point_id","n","k"],remarks:["comment","comments","remark","remarks","note","notes","file","filename","file_name","operator"],units:{angle:{deg:["deg","degs","degree","degrees","°"],rad:["rad","rads","radian","radians"],mrad:["mrad"]},time:{s:["s","sec","secs","second","seconds"],min:["min","mins","minute","minutes"],h:["h","hr","hrs","hour","hours"],d:["d","day","days"],week:["week","weeks","wk"],a:["a","y","yr","yrs","year","years"]},length:{nm:["nm","nanometer","nanometers","nanometre","nanometres"],um:["um","μm","micron","microns","micrometer","micrometers","micrometre","micrometres"],mm:["mm"],m:["m","metre","metres","meter","meters"],angstrom:["å","angstrom","angstroms"]},brdf:{"1/sr":["1/sr","/sr","sr^-1","sr-1","sr**-1","per sr","per steradian","sr^(-1)","sr^{-1}","inverse steradian","sr_1","inv_sr"]},ratio:{"%":["%","percent","pct"],"1":["1","-","dimensionless","fraction"]}},factors:{deg:.017453292519943295,rad:1,mrad:.001,s:.0002777777777777778,min:.016666666666666666,h:1,d:24,week:168,a:8766,nm:1,um:1e3,mm:1e6,m:1e9,angstrom:.1,"1/sr":1,"%":.01,"1":1},missing:["","nan","na","n/a","#n/a","#na","null","none","-","--","nd","n.d.","missing","#value!","#div/0!"]};var Kr=Zt.factors,rd=new Set(Zt.missing),l0={angle:"angle",time:"time",wavelength:"length",value:"brdf",uncertainty:"brdf"},c0={θ:"theta",ϑ:"theta",φ:"phi",ϕ:"phi",λ:"lambda",σ:"sigma",δ:"delta_"},h0=/^(?:x|wl|w|wavelength|lambda|l)?[ _]*((?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d{1,2})?)[ _]*([a-zµμå]*)$/,od=/^(?:(.*?)\s*\[\s*(.+?)\s*\]|(.*?):\s*(.+?))$/,pi=Zt.uncertainty,ad=Zt.channels;function bn(i){let t=i.normalize("NFKC").replaceAll("−","-").replaceAll("µ","μ").trim().toLowerCase().replace(/[θϑφϕλσδ]/g,n=>c0[n]);return pi.signs.reduce((n,s)=>n.replaceAll(s," uncertainty "),t).trim()}var fn=i=>i.replace(/[^a-z0-9]/g,""),Ts=new Map,wa=new Map;for(let[i,e]of[[Zt.angles,"angle"],[Zt.vectors,"vector"],[Zt.values,"value"],[ad,"value"]])for(let[t,n]of Object.entries(i))for(let s of n)Ts.set(fn(s),{role:e,name:t,unit:""});for(let[i,e]of Object.entries(Zt.times))for(let t of e)Ts.set(fn(t),{role:"time",name:"",unit:i});for(let[i,e]of Object.entries(Zt.others))for(let t of e)Ts.set(fn(t),{role:i,name:"",unit:""});for(let i of Zt.index)Ts.set(fn(i),{role:"index",name:"",unit:""});for(let i of Zt.remarks)Ts.set(fn(i),{role:"remark",name:"",unit:""});for(let[i,e]of Object.entries(Zt.values))for(let t of e)wa.set(fn(t),i);var js=new Map;for(let[i,e]of Object.entries(Zt.units))for(let[t,n]of Object.entries(e))for(let s of n)js.set(s,[...js.get(s)??[],[i,t]]);function ls(i,e){let t=js.get(bn(i))?.find(([n])=>n===e||e==="brdf"&&n==="ratio");return t?t[1]:null}var rh=i=>js.has(bn(i)),oh=i=>l0[i]??null,as=(i,e={})=>({role:i,name:"",unit:"",channel:"",wavelength:null,unitOfWavelength:"",relative:!1,expanded:!1,...e});function Jr(i){let e=null;for(let[t,n]of u0(bn(i))){let s=f0(t,i);if(!s||s.role==="index"||s.role==="remark"){if(n===""&&s)return s;continue}if(n==="")return s.unit==="with unit"?null:s;let r=oh(s.role),o=r?ls(n,r):null;if(o!==null&&(s.unit===""||s.unit==="with unit"))return o==="%"&&s.role==="uncertainty"?{...s,unit:"%",relative:!0}:{...s,unit:o};o===null&&n.length>1&&(e??=s)}if(e)throw new oe(`The column '${i}' is ${e.role} ${e.name} by its name, and its unit is that of something else`,"Correct the name");return null}function u0(i){let e=[];for(let t of[/^(.+?)\s*\(([^()]*(?:\(-?1\))?)\)$/,/^(.+?)\s*\[([^[\]]*)\]$/,/^(.+?)\s*\{([^{}]*)\}$/]){let n=t.exec(i);n&&js.has(n[2].trim())&&e.push([n[1],n[2].trim()])}for(let t of[/^(.+?)\s+in\s+(.+)$/,/^(.+?)\s*\/\s*(.+)$/,/^(.+)[\s_.,]+(\S+)$/,/^(.+?)(%|°)$/]){let n=t.exec(i),s=n?.[2].replace(/^[ .]+|[ .]+$/g,"");n&&js.has(s)&&!["1","-"].includes(n[2])&&e.push([n[1],s])}return[...e,[i,""]]}function f0(i,e){let t=Ts.get(fn(i));return t?t.role==="value"&&!(t.name in Zt.values)?as("value",{name:"brdf",channel:t.name}):as(t.role,{name:t.name,unit:t.unit}):d0(i,e)??Aa(i,e)}function Aa(i,e){let t=/^(?:channel|band|ch)[ _]*(\d+)$/.exec(i);if(t)return as("value",{name:"brdf",channel:`channel ${t[1]}`});let n=ld(i);if(n)return n;let s=od.exec(i),r=s?wa.get(fn(s[1]??s[3]??"")):void 0;if(s&&r){let a=hd(s[2]??s[4],e),l=Aa(bn(a),a);return l?.wavelength!=null?{...l,name:r}:as("value",{name:r,channel:a})}let o=i.split(/[^a-z0-9.]+/).filter(Boolean);for(let a=1;a<o.length;a+=1)for(let[l,c]of[[o.slice(0,a),o.slice(a)],[o.slice(-a),o.slice(0,-a)]]){let h=wa.get(l.join("")),u=h?cd(c.join(" ")):null;if(h&&u)return{...u,name:h}}return null}function ld(i){let e=h0.exec(i),t=e?e[2]?ls(e[2],"length"):"":null;return e&&t!==null?as("value",{name:"brdf",channel:i,wavelength:Number(e[1]),unitOfWavelength:t}):null}function cd(i){let e=Ts.get(fn(i));return e?e.name in ad?as("value",{name:"brdf",channel:e.name}):null:ld(i)}function hd(i,e){let t=bn(e).indexOf(i);return t>=0&&bn(e).length===e.trim().length?e.trim().slice(t,t+i.length):i}function d0(i,e){let t=od.exec(i);if(t?.[2]&&[...pi.words,...pi.first].includes(fn(t[1]))){let h=Aa(`brdf[${t[2]}]`,`brdf[${hd(t[2],e)}]`);return h?{...h,role:"uncertainty",name:""}:null}let n=i.replace(/\b(standard|std)[ _.]*(deviation|dev)\b/g,"stddev").split(/[^a-z0-9.]+/).filter(Boolean),s=/k\s*=\s*2\b/.test(i),r=n.some(h=>pi.relative.includes(h)),o=s||n.some(h=>pi.expanded.includes(h)),a=n.filter(h=>!pi.relative.includes(h)&&!pi.expanded.includes(h)&&!(s&&(h==="k"||h==="2"))),l=new Set(a.map((h,u)=>pi.words.includes(h)||u===0&&pi.first.includes(h)?u:-1).filter(h=>h>=0));if(!l.size&&!(o&&!a.length)||a[0]==="u"&&l.has(0)&&e.trim().startsWith("U")&&!o)return null;if(a=a.filter((h,u)=>!l.has(u)&&!pi.passed_over.includes(h)),!a.length||wa.has(a.join("")))return as("uncertainty",{relative:r,expanded:o});let c=cd(a.join(" "))??Aa(a.join(" "),a.join(" "));return c?as("uncertainty",{relative:r,expanded:o,channel:c.channel,wavelength:c.wavelength,unitOfWavelength:c.unitOfWavelength}):null}function ud(i){let e=r=>new Set(Array.from({length:Math.max(r.length-1,1)},(o,a)=>r.slice(a,a+2))),t=e(fn(bn(i))),n=r=>{let o=e(fn(r));return 2*[...o].filter(a=>t.has(a)).length/(o.size+t.size)},s=[Zt.angles,Zt.vectors,Zt.times,Zt.others,Zt.values,Zt.channels].flatMap(r=>Object.values(r).flat());return[...new Set(s.filter(r=>r.length>1))].sort((r,o)=>n(o)-n(r)).slice(0,3)}var lh=/^\s*(?:#|%|\/\/|!)/,p0=400,ch="blanks",hh="two blanks or more",m0=["	",";",",","|",hh,ch],Ta=/^[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?$/,g0=/^([-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?)\s*([^\d\s.,+-].*)$/,v0="A header names the columns, such as theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,brdf";function fd(i){let e=new Uint8Array(i),[t,n]=[e[0],e[1]];if(t===255&&n===254)return new TextDecoder("utf-16le").decode(i);if(t===254&&n===255)return new TextDecoder("utf-16be").decode(i);let s=e.slice(0,2e3);for(let[r,o]of[[1,"utf-16le"],[0,"utf-16be"]]){let a=s.filter((l,c)=>l===0&&c%2===r).length;if(e.length>=8&&a>.4*s.length)return new TextDecoder(o).decode(i)}try{return new TextDecoder("utf-8",{fatal:!0}).decode(i)}catch{return new TextDecoder("windows-1252").decode(i)}}function _0(i){try{let e=Jr(i);return e?e.role==="angle"||e.role==="vector"?"direction":e.role:""}catch{return"direction"}}function y0(i){let e=i.filter(t=>t&&t.length<=100).map(_0).filter(Boolean);return e.includes("direction")&&e.length>=2?e.length:0}function dd(i,e,t=!1){if(e===hh)return i.trim().split(/\s{2,}|\t/).map(ah);if(e===ch){if(!t)return i.trim().split(/\s+/).map(ah);let o=[];for(let a of i.match(/"[^"]*"|[([{][^)\]}]*[)\]}]|[^\s([{"]+(?:[([{][^)\]}]*[)\]}])?/g)??[])o.length&&"([{".includes(a[0])?o[o.length-1]+=` ${a}`:o.push(ah(a));return o}if(!i.includes('"'))return i.split(e).map(o=>o.trim());let n=[],s="",r=!1;for(let o=0;o<i.length;o+=1){let a=i[o];a==='"'&&r&&i[o+1]==='"'?(s+='"',o+=1):a==='"'?r=!r:a===e&&!r?(n.push(s.trim()),s=""):s+=a}return[...n,s.trim()]}var ah=i=>i.trim().replace(/^"|"$/g,"");function x0(i,e,t){let n=pd(i.slice(0,e+50),e+1,t).next();return n.done?null:n.value[1]}function*pd(i,e,t){let n=t===hh?ch:t;for(let s=e;s<i.length;s+=1){let r=i[s];if(!r||lh.test(r))continue;let o=/#(?:N\/A|NA|VALUE|DIV)/i.test(r)?r:r.split("#")[0];if(!o.trim())continue;let a=dd(o,n);a.some(Boolean)&&(yield[s+1,a])}}function b0(i){let e=null,t=null;for(let n=0;n<Math.min(i.length,p0);n+=1){let s=i[n];if(!s.trim())continue;let r=lh.test(s),o=r?s.trim().replace(/^[#%!/]+/,"").trim():s.split("#")[0].trimEnd(),a=null;for(let h of m0){let u=dd(o,h,!0),f=y0(u);f>(a?.[0]??0)&&(a=[f,{at:n,separator:h,cells:u,commented:r}])}if(!a)continue;let l=x0(i,n,a[1].separator),c=l!==null&&a[1].cells.filter(Boolean).length<=l.length&&l.length<=a[1].cells.length+1;if(c&&!r)return a[1];c?e=a[1]:r||(t??=a[1])}return e??t}function md(i,e){let t=e.replace(/^\ufeff/,"").split(/\r\n|\r|\n/),n=b0(t);if(!n)throw new oe(`${i} has no line that names columns of directions; its first line is ${Ut(t.find(a=>a.trim())?.trim()??"")}`,v0);let s=[],r=t.slice(0,n.at).filter(a=>a.trim()&&!lh.test(a)&&!/^\s*sep=.\s*$/i.test(a));r.length&&s.push(`${r.length} line${r.length>1?"s":""} before the header passed over, from '${r[0].trim().slice(0,40)}' on`),n.commented&&s.push("The header stands in a comment, the last before the numbers");let o=[...pd(t,n.at+1,n.separator)];return M0(i,{header:n.cells,rows:o.map(([,a])=>a),lines:o.map(([a])=>a),notes:s,units:[]})}function M0(i,e){let{header:t,rows:n,lines:s}=e,{notes:r}=e;for(;t.length&&t.at(-1)===""&&n.every(u=>u.length<t.length||u[t.length-1]==="");)t=t.slice(0,-1);n=n.map(u=>{let f=u.length;for(;f>t.length&&u[f-1]==="";)f-=1;return u.slice(0,f)}),n.length&&n.every(u=>u.length===t.length+1)&&S0(n.map(u=>u[0]))&&(t=["",...t]);let o=n.map(u=>u.length===t.length&&u.every((f,p)=>f===t[p])),a=o.filter(Boolean).length;a&&(r.push(`The header stands ${a} more time${a>1?"s":""} further down, passed over`),n=n.filter((u,f)=>!o[f]),s=s.filter((u,f)=>!o[f]));let l=[],c=u=>u.replace(/^[()[\] ]+|[()[\] ]+$/g,""),h=n[0];return h&&h.length<=t.length&&h.some(Boolean)&&h.every(u=>u===""||rh(c(u)))&&!h.some(u=>Ta.test(u))&&(l=t.map((u,f)=>c(h[f]??"")),n=n.slice(1),s=s.slice(1),r.push("The row below the header holds units")),n.forEach((u,f)=>{if(u.length!==t.length)throw new oe(`${i}, line ${s[f]} has ${u.length} cells; the header has ${t.length}`,"Each row has a cell for each column, empty where nothing was measured")}),{header:t,rows:n,lines:s,notes:r,units:l}}function S0(i){return i.every(e=>/^\d{1,9}$/.test(e))?(i[0]==="0"||i[0]==="1")&&i.every((e,t)=>Number(e)-Number(i[0])===t):!i.some(e=>Ta.test(e))}var jr=class{constructor(e,t,n){this.name=e;this.table=t;let s=null,r=null;t.rows.forEach((l,c)=>{for(let h of n){let u=l[h];u.includes(",")?s??=[t.lines[c],u]:u.includes(".")&&(r??=[t.lines[c],u])}});let[o,a]=[s,r];if(o&&a&&/\d\.\d|^\./.test(a[1])&&/\d,\d/.test(o[1]))throw new oe(`${e} has numbers with decimal commas ('${o[1].slice(0,20)}', line ${o[0]}) and with decimal points ('${a[1].slice(0,20)}', line ${a[0]})`,"Write all of them in one way");this.decimalComma=o!==null}name;table;decimalComma;column(e){let t="";return{values:this.table.rows.map((s,r)=>{let o=this.decimalComma?s[e].replaceAll(",","."):s[e];if(rd.has(o.toLowerCase()))return NaN;let a=o.replaceAll("−","-").replace(/[\u00a0\u202f]/g,""),l=Ta.test(a)?null:g0.exec(a);if(l&&rh(l[2])){if(a=l[1],t&&bn(l[2])!==bn(t))throw this.error(r,e,`'${l[2].trim()}' stands where '${t}' stands above`);t||=l[2].trim()}let h=/^[-+]?inf(inity)?$/i.test(a)?a.startsWith("-")?-1/0:1/0:Ta.test(a)?Number(a.replace(/[dD]/,"e")):NaN;if(Number.isNaN(h))throw this.error(r,e,`'${o.slice(0,40)}' is not a number`);return h}),unit:t}}error(e,t,n){return new oe(`${this.name}, line ${this.table.lines[e]}: ${n} (column ${this.table.header[t]||t+1})`,"Leave a cell empty where nothing was measured")}};var fh=1e-6,w0=2*Math.PI+1e-6,xd=100,uh="phase",gd=.06*Math.PI/180,vd=["theta_i","phi_i","theta_r","phi_r"],Qr=["theta_h","theta_d","phi_d","phi_h"],eo=["wi_x","wi_y","wi_z","wo_x","wo_y","wo_z"],to="Rename the column, or give motes info the option --read column:NAME=ROLE";function bd(i,e){let t=md(i,e),n=A0(i,t);if(!t.rows.length)throw new oe(`${i} has a header and no row below it`,"It needs a row a sample");let s=[...n.angles.values(),...n.values,...n.uncertainties];for(let p of["weight","wavelength"])n.single.has(p)&&s.push(n.single.get(p));let r=new jr(i,t,s);r.decimalComma&&t.notes.push("Its numbers have decimal commas");let o=P0(i,t,n,r),a=D0(i,t,n),{values:l,factors:c}=U0(i,t,n,r,o),h=O0(i,t,n,r,l,c),u=o.map(([p,g],y)=>({hours:a[y],wi:p,wo:g,values:l[y],uncertainties:h?.[y]??null})),f=n.single.has("scan")?"scan":"h";for(let p of["wavelength","channel"])if(n.single.has(p))return{...B0(i,t,n,r,u,p),unit:f,notes:t.notes};return{...Sd(i,n.values.map(p=>n.columns[p])),unit:f,samples:u,notes:t.notes}}var En=(i,e)=>i[e]?`'${i[e].slice(0,60)}'`:String(e+1);function A0(i,e){let{header:t,notes:n}=e,s={columns:[],angles:new Map,values:[],uncertainties:[],of:[],single:new Map,degrees:[],bare:[]};return t.forEach((r,o)=>{let a=Md(i,r);if(!a&&_d(e,o)){n.push(`The column ${En(t,o)} numbers or names the rows and is left out`),s.columns.push(null);return}if(!a||a.role==="index"&&!_d(e,o))throw T0(i,t,o);if(a.role==="index"||a.role==="remark"){n.push(`The column ${En(t,o)} ${a.role==="index"?"numbers the rows":"holds remarks"} and is left out`),s.columns.push(null);return}let l=E0(i,e,a,o);s.columns.push(l),l.role==="angle"||l.role==="vector"?yd(i,t,s.angles,l.name,o):l.role==="value"?s.values.push(o):l.role==="uncertainty"?s.uncertainties.push(o):yd(i,t,s.single,l.role,o)}),R0(i,e,s),C0(i,e,s),s}function Md(i,e){if(e==="")return null;try{return Jr(e)}catch(t){throw t instanceof oe?new oe(`${i}: t${t.message.slice(1)}`,to):t}}function _d(i,e){let t=bn(i.header[e]),n=t===""||/^unnamed:? ?\d+(\.\d+)*$/.test(t);if(!n&&Jr(t)?.role!=="index")return!1;let s=i.rows.map(o=>o[e]);if(s.every(o=>o===""))return!0;let r=s.map(o=>o===""?NaN:Number(o));return r.some(Number.isNaN)?n&&new Set(s).size===s.length&&r.every(Number.isNaN):r.length<2||r.every((o,a)=>a===0||o-r[a-1]===1)||!n&&r.every(Number.isInteger)}function T0(i,e,t){return e[t]?new oe(`${i}: the column ${En(e,t)} is not known; the nearest names are ${ud(e[t]).join(", ")}`,to):new oe(`${i}: column ${t+1} has no name and does not number the rows`,to)}function E0(i,e,t,n){let s=e.units[n]??"";t.role==="value"&&(t.unit==="%"||t.unit==="1")&&(s||=t.unit);let r=oh(t.role);if(!s||!r)return t;let o=ls(s,r),a=t.unit==="with unit"?"":t.unit,l=e.header[n];if(o===null||a&&a!==o)throw new oe(`${i}: the column '${l}' has the unit '${s}'${a?`, and its name says ${a}`:`, which is no unit of ${t.name||t.role}`}`,"Correct one of them");if(t.role==="value"&&t.name!=="reflectance_factor"&&(o==="%"||o==="1"))throw new oe(`${i}: the column '${l}' has the unit '${s}', and a BRDF is in 1/sr`,"Where it is pi times the BRDF, call it reflectance_factor");return{...t,unit:o,relative:t.relative||t.role==="uncertainty"&&o==="%"}}function yd(i,e,t,n,s){if(t.has(n))throw new oe(`${i}: the columns ${En(e,t.get(n))} and ${En(e,s)} are both ${n}`,"Leave one out");t.set(n,s)}function R0(i,e,t){let n=t.angles.get("theta_s");if(n===void 0)return;if(t.angles.delete("theta_s"),t.angles.has("theta_i")===t.angles.has("theta_r"))throw new oe(`${i}: the column ${En(e.header,n)} may be the angle of the scattered light or of the sun`,to);let s=t.angles.has("theta_i")?"theta_r":"theta_i";t.angles.set(s,n),e.notes.push(`The column ${En(e.header,n)} is taken for ${s}, the other one being there`);let r=t.angles.get("phi_r");s==="theta_i"&&r!==void 0&&fn(bn(e.header[r])).startsWith("phis")&&(t.angles.delete("phi_r"),t.angles.set("phi_i",r))}function C0(i,e,t){let{header:n}=e,s=["wavelength","channel"].filter(o=>t.single.has(o));if(s.length===2)throw new oe(`${i}: two columns name the channel of a row`,"Leave one out");if(t.single.has("time")&&t.single.has("scan")&&t.single.delete("scan"),!t.values.length)throw new oe(`${i} has no column of values; its columns are ${n.slice(0,12).join(", ")}`,"Name a column of the BRDF [1/sr] brdf, or R, G, B, or by its wavelength (630 nm)");if(s.length&&t.values.length>1)throw new oe(`${i} has a row for each ${s[0]} and yet ${t.values.length} columns of values`,"Leave all but one out");let r=new Map;for(let o of t.values){let a=t.columns[o],l=a.wavelength===null?a.channel:`${a.wavelength} ${a.unitOfWavelength}`;if(r.has(l))throw new oe(`${i}: the columns ${En(n,r.get(l))} and ${En(n,o)} hold values of the same channel`,"Leave one out");r.set(l,o)}for(let o of t.uncertainties){let a=I0(i,e,t,o);if(t.of.includes(a)||t.of.length&&(a===-1||t.of.includes(-1)))throw new oe(`${i}: the columns ${En(n,t.uncertainties[Math.max(t.of.indexOf(a),0)])} and ${En(n,o)} are both uncertainties of the same values`,"Leave one out");t.of.push(a)}}function I0(i,e,t,n){let s=t.columns[n];if(s.channel===""&&s.wavelength===null){if(t.values.length>1&&!s.relative)throw new oe(`${i}: the column ${En(e.header,n)} is an uncertainty [1/sr] of one of ${t.values.length} channels, and does not say of which`,"Call it uncertainty[R], for example");return t.values.length===1?0:-1}let r=t.values.map((o,a)=>a).filter(o=>{let a=t.columns[t.values[o]];return s.wavelength===null?fn(bn(a.channel))===fn(bn(s.channel)):a.wavelength===s.wavelength&&["",a.unitOfWavelength].includes(s.unitOfWavelength)});if(r.length!==1)throw new oe(`${i}: the column ${En(e.header,n)} is the uncertainty of ${s.channel}, and no column of values is called so`,to);return r[0]}function P0(i,e,t,n){let s=y=>t.angles.has(y),r=[eo,Qr,[...vd,uh]].filter(y=>y.some(s)),o=s(uh);if(r.length!==1||o&&s("phi_r"))throw new oe(`${i} gives directions in several ways: ${[...t.angles.keys()].join(", ")}`,"Leave one way out");let l=(r[0]===eo?eo:r[0]===Qr?Qr.slice(0,3):o?["theta_i","theta_r"]:["theta_i","theta_r","phi_r"]).filter(y=>!s(y));if(l.length)throw new oe(`${i} has no column ${l.join(", ")}; it has ${e.header.slice(0,12).join(", ")}`,"Add them");let c=y=>{let m=t.angles.get(y),v=n.column(m),A=v.values.findIndex(S=>!Number.isFinite(S));if(A>=0)throw new oe(`${i}, line ${e.lines[A]}: ${e.header[m]} is missing or not finite`,"Fill it in");return v},h=y=>s(y)?L0(i,e,t,y,c(y)):e.rows.map(()=>0);if(r[0]===eo){let y=eo.map(m=>c(m).values);return e.rows.map((m,v)=>[0,3].map(S=>[0,1,2].map(w=>y[S+w][v])).map((S,w)=>{let T=Math.hypot(...S);if(!(Math.abs(T-1)<=.001))throw new oe(`${i}: ${w?"wo":"wi"} in row ${v} has the length ${T.toPrecision(6)} instead of 1`,"Directions are unit vectors");return S.map(E=>E/T)}))}if(r[0]===Qr){let[y,m,v,A]=Qr.map(h);return e.rows.map((S,w)=>N0(y[w],m[w],v[w],A[w]))}let[u,f,p,g]=vd.map(h);return o&&(h(uh).forEach((m,v)=>{let[A,S]=[u[v],p[v]];if(m<Math.abs(A-S)-gd||m>A+S+gd||A<0||S<0)throw new oe(`${i}, line ${e.lines[v]}: a phase angle of ${(m*180/Math.PI).toPrecision(6)} degrees is outside what the two polar angles allow`,"Check the row; polar angles beside a phase angle are not signed");let w=Math.sin(A)*Math.sin(S);g[v]=f[v]+(w>1e-12?Math.acos(Math.min(1,Math.max(-1,(Math.cos(m)-Math.cos(A)*Math.cos(S))/w))):0)}),e.notes.push("The azimuth between light and viewer follows from the phase angle")),s("phi_i")||e.notes.push("phi_i is missing and taken as 0"),[...u,...p].some(y=>y<0)&&e.notes.push("Negative polar angles are taken for the opposite azimuth"),e.rows.map((y,m)=>[Ea(u[m],f[m]),Ea(p[m],g[m])])}function L0(i,e,t,n,s){let r=t.angles.get(n),o=e.header[r],a=t.columns[r].unit,l=s.unit?ls(s.unit,"angle"):"";if(l===null||l&&a&&l!==a)throw new oe(`${i}: the cells of '${o}' are in '${s.unit}'${a?`, its name says ${a}`:""}`,"Correct one of them");let c=a||l;if(c==="deg"?t.degrees.push(o):c||t.bare.push(o),t.bare.length&&(t.degrees.length||t.columns.some(f=>f?.role==="angle"&&f.unit==="deg")))throw new oe(`${i}: '${t.bare[0]}' names no unit, and other angles are in degrees`,`Call it ${t.bare[0]}_deg or ${t.bare[0]}_rad`);let h=s.values.map(f=>f*Kr[c||"rad"]),u=h.findIndex(f=>Math.abs(f)>w0);if(u>=0)throw new oe(`${i}, line ${e.lines[u]}: ${o} = ${s.values[u]} is outside +-2 pi rad (+-360 degrees)`,c?"Check the row":`Angles are in radians; call it ${o}_deg for degrees`);return h}var Ea=(i,e)=>[Math.sin(i)*Math.cos(e),Math.sin(i)*Math.sin(e),Math.cos(i)];function N0(i,e,t,n){let[s,r,o]=Ea(e,t),[a,l]=[Math.cos(i),Math.sin(i)],[c,h,u]=[a*s+l*o,r,a*o-l*s],[f,p]=[Math.cos(n),Math.sin(n)],g=[f*c-p*h,p*c+f*h,u],y=Ea(i,n),m=2*(g[0]*y[0]+g[1]*y[1]+g[2]*y[2]);return[g,[m*y[0]-g[0],m*y[1]-g[1],m*y[2]-g[2]]]}function D0(i,e,t){let n=["time","scan"].find(u=>t.single.has(u));if(!n)return e.rows.map(()=>0);let s=t.single.get(n),r=e.rows.map(u=>u[s].trim());if(n==="time"&&/\d[:/-]\d|\d\.\d+\.\d/.test(r.find(Boolean)??""))return F0(i,e,s,r);let{values:o,unit:a}=new jr(i,e,[s]).column(s),l=o.findIndex(u=>!Number.isFinite(u));if(l>=0)throw new oe(`${i}, line ${e.lines[l]}: ${e.header[s]} is missing or not finite`,"Fill it in");if(n==="scan")return o;let c=t.columns[s].unit,h=a?ls(a,"time"):"";if(h===null||h&&c&&h!==c)throw new oe(`${i}: the cells of '${e.header[s]}' are in '${a}'`,"Correct one of them");return o.map(u=>u*Kr[c||h||"h"])}function F0(i,e,t,n){let s=n.map(a=>/^(-?)(\d{1,6}):(\d{2})(?::(\d{2}(?:\.\d+)?))?$/.exec(a));if(s.every(Boolean))return s.map(a=>(a[1]?-1:1)*(Number(a[2])+Number(a[3])/60+Number(a[4]??0)/3600));let r=n.map((a,l)=>{let c=/^(\d{4})-(\d{2})-(\d{2})(?:[T ](\d{2}):(\d{2})(?::(\d{2}(?:\.\d+)?))?)?(Z|[+-]\d{2}:\d{2})?$/.exec(a);if(!c)throw new oe(`${i}, line ${e.lines[l]}: '${a.slice(0,40)}' is no time`,`Write dates in ${En(e.header,t)} as 2024-05-01 10:30, durations as 1:30:00, or numbers of hours`);let h=!c[7]||c[7]==="Z"?0:(c[7][0]==="-"?-1:1)*(Number(c[7].slice(1,3))+Number(c[7].slice(4))/60);return Date.UTC(Number(c[1]),Number(c[2])-1,Number(c[3]))/36e5+Number(c[4]??0)+Number(c[5]??0)/60+Number(c[6]??0)/3600-h}),o=Math.min(...r);return r.map(a=>a-o)}function U0(i,e,t,n,s){let r=t.values.map(c=>n.column(c));r.forEach(({unit:c},h)=>{if(c&&ls(c,"brdf")!=="1/sr")throw new oe(`${i}: the cells of '${e.header[t.values[h]]}' are in '${c}', and a BRDF is in 1/sr`,"Write the unit in the header")});let o=t.values.map(c=>t.columns[c]);o.some(c=>c.name==="reflectance_factor")&&e.notes.push("f_r = reflectance factor / pi"),o.some(c=>c.name==="brdf_cos_r")&&e.notes.push("f_r = cosine-corrected BRDF / cos(theta_r)"),o.some(c=>c.name==="brdf_cos_i")&&e.notes.push("f_r = BRDF times cos(theta_i) / cos(theta_i)");let a=c=>c>0?1/c:NaN,l=s.map(([c,h])=>o.map(u=>u.name==="reflectance_factor"?Kr[u.unit||"1"]/Math.PI:u.name==="brdf_cos_r"?a(h[2]):u.name==="brdf_cos_i"?a(c[2]):1));return{values:l.map((c,h)=>c.map((u,f)=>r[f].values[h]*u)),factors:l}}function O0(i,e,t,n,s,r){if(!t.uncertainties.length)return null;let o=s.map(a=>a.map(()=>NaN));return t.uncertainties.forEach((a,l)=>{let c=t.columns[a],{values:h,unit:u}=n.column(a),f=c.unit==="%"||u==="%"?.01:1,p=t.of[l]<0?t.values.map((y,m)=>m):[t.of[l]],g=h.filter((y,m)=>p.some(v=>Number.isFinite(s[m][v]))&&!(y>0&&Number.isFinite(y)));if(g.length)throw new oe(`${i}: the uncertainty ${e.header[a]}: ${g.length} of ${h.length} are not above 0`,"An uncertainty is one standard deviation");h.forEach((y,m)=>{for(let v of p){let S=y*f/(c.expanded?2:1)*Math.abs(c.relative||u==="%"?s[m][v]:r[m][v]);S>0&&(o[m][v]=S)}})}),o}function Sd(i,e){if(e.every(t=>t.wavelength!==null)){let t=new Set(e.map(s=>s.unitOfWavelength));if(t.size===2&&t.has("")&&t.has("nm")&&t.delete(""),t.size>1)throw new oe(`${i}: the wavelengths are in ${[...t].map(s=>s||"no unit").sort().join(", ")}`,"Write all in one unit");let n=Ad(i,e.map(s=>s.wavelength),[...t][0]);return{channels:n.map(wd),wavelengths:n}}return{channels:e.map(t=>t.channel||(e.length===1?"grey":t.name)),wavelengths:null}}var wd=i=>`${Number(i.toPrecision(6))} nm`;function Ad(i,e,t){let n=e.reduce((s,r)=>Math.min(s,r));if(!t&&n<xd)throw new oe(`${i}: the wavelengths, from ${n} to ${e.reduce((s,r)=>Math.max(s,r))}, name no unit and are no light in nm`,"Write their unit, as in 0.63 um");return e.map(s=>Number((s*Kr[t||"nm"]).toFixed(6)))}function B0(i,e,t,n,s,r){let o=t.single.get(r),a,l=null,c;if(r==="wavelength"){let{values:y,unit:m}=n.column(o),v=y.findIndex(w=>!(w>0&&Number.isFinite(w)));if(v>=0)throw new oe(`${i}, line ${e.lines[v]}: ${e.header[o]} is missing or not above 0`,"Fill it in");let A=Ad(i,y,t.columns[o].unit||(m?ls(m,"length")??"":""));l=[...new Set(A)].sort((w,T)=>w-T),a=l.map(wd);let S=new Map(l.map((w,T)=>[w,T]));c=A.map(w=>S.get(w))}else{let y=e.rows.map(w=>w[o]),m=y.indexOf("");if(m>=0)throw new oe(`${i}, line ${e.lines[m]}: ${e.header[o]} is missing`,"Fill it in");let v=[...new Set(y)],A=new Map(v.map((w,T)=>[w,T]));c=y.map(w=>A.get(w));let S=v.map(w=>Md(i,/^\d+$/.test(w)&&Number(w)<xd?`channel ${w}`:w));S.every(w=>w?.role==="value")?{channels:a,wavelengths:l}=Sd(i,S):a=v}let h=new Map;s.forEach((y,m)=>{let v=[y.hours,...y.wi,...y.wo].map(A=>(Math.round(A*1e6)+0).toString()).join(" ");h.has(v)||h.set(v,{sample:y,rows:a.map(()=>[])}),h.get(v).rows[c[m]].push(m)});let u=[],f=a.map((y,m)=>[...h.values()].reduce((v,A)=>v+A.rows[m].length,0)),p=[...h.values()].reduce((y,m)=>y+Math.max(...m.rows.map(v=>v.length)),0),g=f.findIndex(y=>y<p);if(g>=0)throw new oe(`${i}: the channel ${a[g]} has ${f[g]} of ${p} directions`,"Give each channel a row for each pair of directions, with an empty cell where nothing was measured");for(let y of h.values())y.rows[0].forEach((m,v)=>{let A=y.rows.map(S=>s[S[v]]);u.push({...y.sample,values:A.map(S=>S.values[0]),uncertainties:A[0].uncertainties&&A.map(S=>S.uncertainties[0])})});return{channels:a,wavelengths:l,samples:u}}var Td=6e3,Ed=200*2**20;function Rd(i){let[e,t,n]=[i.wi,i.wo,i.values].map(s=>new Float32Array(Ni(s)));return Id(i.name,i.channels,i.hours,i.time_unit,e,t,n,i.note)}function Cd(i,e){if(e.length>Ed)throw new oe(`${i} has ${Math.round(e.length/2**20)} MB, more than ${Ed/2**20}`,"motes view DATA thins any measurement");let t=bd(i,e),n=t.samples.filter(({wi:m,wo:v})=>m[2]>fh&&v[2]>fh),s=t.samples.length-n.length;if(!n.length)throw new oe(`${i} has no usable row`,"It needs a row a sample, with both directions above the horizon");let r=t.channels.length,o=t.channels.map((m,v)=>n.reduce((A,{values:S})=>S[v]>A&&S[v]<1/0?S[v]:A,0)),a=(m,v)=>Number.isFinite(m)&&m>=-o[v]?m:NaN,l=[...new Set(n.map(m=>m.hours))].sort((m,v)=>m-v),c=Math.max(n.length/Td,1),h=Array.from({length:Math.min(n.length,Td)},(m,v)=>n[Math.floor(v*c)]),u=h.length,f=new Float32Array(3*u),p=new Float32Array(3*u),g=new Float32Array(l.length*u*r).fill(NaN);h.forEach((m,v)=>{f.set(m.wi,3*v),p.set(m.wo,3*v),g.set(m.values.map(a),(l.indexOf(m.hours)*u+v)*r)});let y=[h.length<n.length?`${i} has ${n.length.toLocaleString("en")} samples; ${h.length.toLocaleString("en")} of them, evenly spread, are shown.`:"",s?`${s.toLocaleString("en")} rows with a direction at or below the horizon were left out.`:"",...t.notes.map(m=>`${m}.`)];return Id(i,t.channels,l,t.unit,f,p,g,y.filter(Boolean).join(" "))}function Id(i,e,t,n,s,r,o,a){let l=s.length/3,[c,h,u,f]=[0,0,0,0].map(()=>new Float32Array(l));for(let p=0;p<l;p+=1){let[g,y,m,v,A,S]=[s[3*p],s[3*p+1],s[3*p+2],r[3*p],r[3*p+1],r[3*p+2]];c[p]=Math.atan2(Math.hypot(g,y),m),h[p]=Math.atan2(Math.hypot(v,A),S),u[p]=Math.atan2(Math.hypot(g+v,y+A),m+S),f[p]=Math.atan2(g*A-y*v,g*v+y*A)}return{name:i,channels:e,hours:t,unit:n,count:l,wi:s,wo:r,values:o,thetaI:c,thetaR:h,thetaH:u,dphi:f,note:a}}function Ra(i,e){return i.hours.reduce((t,n,s)=>Math.abs(n-e)<Math.abs(i.hours[t]-e)?s:t,0)}function dh(i){let e=new Float64Array(90);for(let r=0;r<i.count;r+=1){if(Math.abs(Math.sin(i.dphi[r]))*Math.min(Math.sin(i.thetaI[r]),Math.sin(i.thetaR[r]))>.05)continue;let a=Math.round(i.thetaI[r]*180/Math.PI);a<=$t.incidence.high&&(e[a]+=1)}let t=.4*Math.max(...e),n=45,s=1/0;return e.forEach((r,o)=>{r>=t&&t>0&&Math.abs(o-45)<s&&([n,s]=[o,Math.abs(o-45)])}),n}var[Ca,Pd,cs]=[360,214,150],[Di,jn]=[Ca/2,186],Ia=class{constructor(e){this.turn=e;this.handle=dt("g",{role:"slider",tabindex:0,class:"motes-incident","aria-label":"Angle of incidence in degrees","aria-valuemin":$t.incidence.low,"aria-valuemax":$t.incidence.high,"aria-valuenow":0},this.ray,this.grip),this.svg=dt("svg",{viewBox:`0 0 ${Ca} ${Pd}`,class:"motes-chart motes-polar",role:"group","aria-labelledby":this.title.id},this.title,this.body,this.handle),this.handle.addEventListener("pointerdown",t=>this.begin(t)),this.handle.addEventListener("keydown",t=>this.key(t))}turn;svg;title=dt("title",{id:Ii("polar")},"Polar plot");body=dt("g");handle;now=0;ray=dt("line",{class:"incident"});grip=dt("circle",{r:9,class:"grip"});draw(e,t,n,s,r){this.title.textContent=e,this.now=t;let o=0;for(let{radius:h}of[...n,...s])for(let u=0;u<h.length;u+=1)Number.isFinite(h[u])&&(o=Math.max(o,h[u]));let a=o>0?o:1;this.body.replaceChildren(...this.grid(a,r));for(let{theta:h,radius:u,tint:f,dashed:p}of n){let g="";for(let y=0;y<h.length;y+=1){let[m,v]=no(h[y],u[y]/a*cs);g+=`${y?"L":"M"}${m.toFixed(1)} ${v.toFixed(1)}`}this.body.append(dt("path",{d:g,class:`line ${f}${p?" dashed":""}`}))}for(let{theta:h,radius:u,tint:f}of s){let p="";for(let g=0;g<h.length;g+=1){let[y,m]=no(h[g],u[g]/a*cs);Number.isFinite(y)&&Number.isFinite(m)&&(p+=`M${y.toFixed(1)} ${m.toFixed(1)}h0`)}this.body.append(dt("path",{d:p,class:`dots ${f}`}))}let[l,c]=no(-Qt(t),cs);for(let[h,u]of[["x1",l],["y1",c],["x2",Di],["y2",jn]])this.ray.setAttribute(h,u.toFixed(1));this.grip.setAttribute("cx",l.toFixed(1)),this.grip.setAttribute("cy",c.toFixed(1)),this.handle.setAttribute("aria-valuenow",ht(t)),this.handle.setAttribute("aria-valuetext",`${ht(t)} degrees from the normal`)}grid(e,t){let n=[dt("line",{x1:Di-cs,x2:Di+cs,y1:jn,y2:jn,class:"axis"})];for(let s of va(0,e,3).slice(1)){let r=s/e*cs;n.push(dt("path",{d:`M${Di-r} ${jn}A${r} ${r} 0 0 1 ${Di+r} ${jn}`,class:"grid"}),dt("text",{x:Di+r,y:jn+13,class:"tick","text-anchor":"middle"},t(s)))}for(let s of[-60,-30,0,30,60]){let[r,o]=no(Qt(s),cs+4),[a,l]=no(Qt(s),cs+15);n.push(dt("line",{x1:Di,y1:jn,x2:r,y2:o,class:"grid"}),dt("text",{x:a,y:l+4,class:"tick","text-anchor":"middle"},`${Math.abs(s)}°`))}return n.push(dt("text",{x:6,y:jn+26,class:"tick"},"light"),dt("text",{x:Ca-6,y:jn+26,class:"tick","text-anchor":"end"},"mirror side")),n}begin(e){e.preventDefault(),this.handle.focus(),this.handle.setPointerCapture(e.pointerId);let t=s=>{let r=this.svg.getBoundingClientRect(),o=(s.clientX-r.left)/r.width*Ca-Di,a=jn-(s.clientY-r.top)/r.height*Pd;this.set(fi(Math.atan2(-o,Math.max(a,0))))},n=()=>{this.handle.removeEventListener("pointermove",t),this.handle.removeEventListener("pointerup",n),this.handle.removeEventListener("pointercancel",n)};this.handle.addEventListener("pointermove",t),this.handle.addEventListener("pointerup",n),this.handle.addEventListener("pointercancel",n)}key(e){let t={ArrowLeft:1,ArrowUp:1,ArrowRight:-1,ArrowDown:-1,PageUp:10,PageDown:-10},n=e.key==="Home"?$t.incidence.low:e.key==="End"?$t.incidence.high:e.key in t?this.now+t[e.key]:null;n!==null&&(e.preventDefault(),this.set(n))}set(e){this.now=Math.round(Fn(e,$t.incidence.low,$t.incidence.high)*2)/2,this.turn(this.now)}};function no(i,e){return[Di+Math.sin(i)*e,jn-Math.cos(i)*e]}function hs(i,e){return e==="cube root"?Math.cbrt(i):i}function Qs(i){return[-Math.sin(i),0,Math.cos(i)]}function mi(i,e){let t=i.length,n=(s,r)=>s.map((o,a)=>({channel:o,name:i[o]??String(o),tint:r[a]??"grey"}));if(t===1)return n([0],["grey"]);if(t===3)return n([0,1,2],["red","green","blue"]);if(t<=4)return n(i.map((s,r)=>r),["blue","green","red","grey"]);if(e.length===t){let s=r=>e.reduce((o,a,l)=>Math.abs(a-r)<Math.abs(e[o]-r)?l:o,0);return n([s(650),s(550),s(450)],["red","green","blue"])}return n([0,t>>1,t-1],["red","green","blue"])}var ph=179,k0=3,z0=2.5;function La(i,e,t=z0){let n=[],s=Math.sin(Qt(k0));for(let r=0;r<i.count;r+=1)Math.abs(fi(i.thetaI[r])-e)>t||Math.abs(Math.sin(i.dphi[r]))*Math.min(Math.sin(i.thetaR[r]),Math.max(Math.sin(i.thetaI[r]),.05))<=s&&n.push(r);return n}function mh(i,e){return Math.cos(i.dphi[e])>0?-i.thetaR[e]:i.thetaR[e]}var Pa=class{element;polar;radius;scale;words=Ee("p",{class:"motes-caption"});constructor(e){this.polar=new Ia(t=>e({incidence:t})),this.radius=new Li("Radius",[["f","f, the BRDF"],["f cos","f cos θ"]],t=>e({radius:t})),this.scale=new Li("Scale",[["linear","linear"],["cube root","cube root"]],t=>e({scale:t})),this.element=Ee("div",{},this.polar.svg,this.words,Ee("div",{class:"motes-pair"},this.radius.element,this.scale.element))}update(e,t,n,s,r){this.radius.show(e.radius),this.scale.show(e.scale);let o=Qs(-Qt(e.incidence)),a=Float32Array.from({length:ph},(v,A)=>Qt(A+1-90)),l=Float32Array.from([...a].flatMap(Qs)),c=new Float32Array(l.length);for(let v=0;v<ph;v+=1)c.set(o,3*v);let h=v=>e.radius==="f cos"?Math.cos(v):1,u=[],f=[],p=e.compare==="one"?[e.active]:t.map((v,A)=>A);for(let v of p){let A=t[v];if(!A)continue;let S=s.evaluate(A,n[v],c,l),w=A.shader.channels;for(let{channel:E,tint:x}of mi(A.channels,A.wavelengths)){let b=a.map((L,I)=>hs(S[I*w+E]*h(L),e.scale));u.push({theta:a,radius:b,tint:x,dashed:v>0&&p.length>1})}let T=0;for(let E=1;E<ph;E+=1)S[E*w]>S[T*w]&&(T=E);f.push(`${A.name}: largest ${ht(S[T*w])} 1/sr at ${ht(fi(a[T]))}°`)}let g=[],y=t[0];if(r&&y&&p.includes(0)){let v=Ra(r,e.hours),A=La(r,e.incidence),S=A.map(w=>mh(r,w));for(let{channel:w,tint:T}of mi(r.channels,y.wavelengths)){let E=A.map((x,b)=>hs(r.values[(v*r.count+x)*r.channels.length+w]*h(S[b]),e.scale));g.push({theta:S,radius:E,tint:T,dashed:!1})}}let m=`The ${e.radius==="f"?"BRDF":"BRDF times the cosine"} in the plane of incidence, light at ${ht(e.incidence)}° from the normal. ${f.join("; ")}.`;this.polar.draw(m,e.incidence,u,g,v=>ht(e.scale==="cube root"?v**3:v,2)),this.words.textContent=`Light at ${ht(e.incidence)}°. ${f.join("; ")}.${g.some(v=>v.theta.length)?" Dots: measured.":""} Drag the yellow handle, or focus it and use the arrow keys.`}};var H0=[-90,-60,-30,0,30,60,90],G0=2500,Na=class{element;curve=new As("Measured and computed");rest=new As("Residuals",170);words=Ee("p",{class:"motes-caption"});restWords=Ee("p",{class:"motes-caption"});incidence;relativeRms=NaN;constructor(e,t){this.incidence=new Pi({label:"angle of incidence",symbol:"θ_i",unit:"°",...$t.incidence,step:1,set:n=>e({incidence:Math.min(Math.max(n,0),88)})},t),this.element=Ee("div",{},this.curve.svg,this.words,this.incidence.element,this.rest.svg,this.restWords)}update(e,t,n,s,r){this.incidence.show(e.incidence);let o=t.shader.channels,a=mi(r.channels,t.wavelengths),l=Ra(r,e.hours),c=(b,L)=>r.values[(l*r.count+b)*r.channels.length+L],h=b=>o===1?0:Math.min(b,o-1),u=Float32Array.from({length:179},(b,L)=>Qt(L+1-90)),f=Float32Array.from([...u].flatMap(Qs)),p=new Float32Array(f.length);for(let b=0;b<u.length;b+=1)p.set(Qs(-Qt(e.incidence)),3*b);let g=s.evaluate(t,n,p,f),y=La(r,e.incidence),m=a.map(({channel:b})=>y.map(L=>hs(c(L,b),e.scale))),v=a.map(({channel:b})=>Array.from(u,(L,I)=>hs(g[I*o+h(b)],e.scale))),A=0,S=Qt(86);for(let b of m)for(let L of b)L>A&&(A=L);for(let b of v)b.forEach((L,I)=>Math.abs(u[I])<S&&L>A?A=L:0);let w=b=>ht(e.scale==="cube root"?b**3:b,2),T=`${r.name}: measured and computed BRDF in the plane of incidence at ${ht(e.incidence)}°`;this.curve.begin(T,{low:-90,high:90,ticks:H0,label:"θ_r (°), mirror side positive"},{low:0,high:A*1.06||1,label:"f (1/sr)",write:w}),a.forEach(({tint:b},L)=>{this.curve.line({x:u.map(fi),y:v[L],tint:b}),this.curve.dots(y.map(I=>fi(mh(r,I))),m[L],b)}),this.curve.mark(-e.incidence);let E=y.length?"":` No sample lies within 2.5° of this incidence and 3° of the plane; the nearest incidence with one is ${this.nearest(r,e.incidence)}.`,x=r.hours.length>1?` Scan ${l+1} of ${r.hours.length}, at ${ht(r.hours[l])} ${r.unit}.`:"";this.words.textContent=`${y.length} measured directions near the plane of incidence (dots), the model (lines).${x}${E}`,this.residuals(t,n,s,r,l,c,h)}residuals(e,t,n,s,r,o,a){let l=e.shader.channels,c=n.evaluate(e,t,s.wi,s.wo),[h,u,f]=[0,0,0],p=mi(s.channels,e.wavelengths),g=p.map(()=>new Float32Array(s.count));for(let T=0;T<s.count;T+=1){for(let E=0;E<s.channels.length;E+=1){let x=o(T,E),b=c[T*l+a(E)]-x;Number.isFinite(b)&&(h+=b*b,u+=x*x,f+=1)}p.forEach(({channel:E},x)=>g[x][T]=c[T*l+a(E)]-o(T,E))}let y=Math.sqrt(u/Math.max(f,1))||1;this.relativeRms=Math.sqrt(h/Math.max(f,1))/y;let m=Math.max(Math.ceil(s.count/G0),1),v=Array.from({length:Math.floor(s.count/m)},(T,E)=>E*m),A=g.flatMap(T=>v.map(E=>Math.abs(T[E]))).filter(Number.isFinite).sort((T,E)=>T-E),S=(A[Math.floor(.98*(A.length-1))]??1)/y*100*1.15||1,w=`Residuals of ${s.name}: computed less measured, in percent of the measured root mean square, over theta_h; relative RMS ${ht(100*this.relativeRms,3)} %`;this.rest.begin(w,{low:0,high:90,ticks:[0,15,30,45,60,75,90],label:"θ_h (°)"},{low:-S,high:S,label:"residual (%)"}),p.forEach(({tint:T},E)=>this.rest.dots(v.map(x=>fi(s.thetaH[x])),v.map(x=>g[E][x]/y*100),T)),this.restWords.textContent=`Computed less measured, in percent of the measured root mean square. Relative RMS ${ht(100*this.relativeRms,3)} % over ${f.toLocaleString("en")} samples${s.hours.length>1?` of scan ${r+1}`:""}.${s.note?` ${s.note}`:""}`}nearest(e,t){let n=NaN;for(let s=0;s<e.count;s+=1){let r=fi(e.thetaI[s]);if(!(Math.abs(r-t)>=Math.abs(n-t))&&La(e,r,1).length&&(n=r),s>400&&Number.isFinite(n))break}return Number.isFinite(n)?`${ht(n,3)}°`:"none"}};var yp=0,Qh=1,xp=2;var Ho=1,bp=2,Ir=3,Zn=0,hn=1,Ln=2,Hs=0,Pr=1,eu=2,tu=3,nu=4,Mp=5;var Gs=100,Sp=101,wp=102,Ap=103,Tp=104,Ep=200,Rp=201,Cp=202,Ip=203,iu=204,su=205,Pp=206,Lp=207,Np=208,Dp=209,Fp=210,Up=211,Op=212,Bp=213,kp=214,ll=0,cl=1,hl=2,mr=3,ul=4,fl=5,dl=6,pl=7,ru=0,zp=1,Hp=2,bi=0,Go=1,ou=2,au=3,lu=4,cu=5,Vo=6,Lr=7,Hh="attached",Gp="detached",hu=300,Vs=301,Nr=302,Dl=303,Fl=304,_s=1e3,Rn=1001,gr=1002,Pt=1003,Ul=1004;var Ws=1005;var Et=1006,Dr=1007;var Vn=1008;var Nn=1009,uu=1010,fu=1011,Fr=1012,Ol=1013,ri=1014,_t=1015,Jt=1016,Bl=1017,kl=1018,$s=1020,du=35902,pu=35899,mu=1021,gu=1022,yt=1023,Vi=1026,es=1027,ts=1028,zl=1029,Dn=1030,Hl=1031;var Gl=1033,Wo=33776,$o=33777,Xo=33778,qo=33779,Vl=35840,Wl=35841,$l=35842,Xl=35843,ql=36196,Yl=37492,Zl=37496,Kl=37488,Jl=37489,Yo=37490,jl=37491,Ql=37808,ec=37809,tc=37810,nc=37811,ic=37812,sc=37813,rc=37814,oc=37815,ac=37816,lc=37817,cc=37818,hc=37819,uc=37820,fc=37821,dc=36492,pc=36494,mc=36495,gc=36283,vc=36284,Zo=36285,_c=36286;var Ls=2300,Ns=2301,ol=2302,Gh=2303,Vh=2400,Wh=2401,$h=2402,Vp=2500;var vu=0,Ko=1,Ur=2,Wp=3200;var yc=0,$p=1,ns="",Xt="srgb",Ot="srgb-linear",mo="linear",bt="srgb";var al=7680;var Xp=519,qp=512,Yp=513,Zp=514,_u=515,Kp=516,Jp=517,yu=518,xu=519,bu=35044;var wn="300 es",qn=2e3,vr=2001;function V0(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function W0(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function _r(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function jp(){let i=_r("canvas");return i.style.display="block",i}var Ld={},yr=null;function go(...i){let e="THREE."+i.shift();yr?yr("log",e,...i):console.log(e,...i)}function Qp(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function ke(...i){i=Qp(i);let e="THREE."+i.shift();if(yr)yr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ke(...i){i=Qp(i);let e="THREE."+i.shift();if(yr)yr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ps(...i){let e=i.join(" ");e in Ld||(Ld[e]=!0,ke(...i))}function em(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var tm={[ll]:ll,[hl]:dl,[ul]:ul,[mr]:fl,[cl]:cl,[dl]:hl,[pl]:pl,[fl]:mr},_i=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},dn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Nd=1234567,fo=Math.PI/180,Ds=180/Math.PI;function Mi(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(dn[i&255]+dn[i>>8&255]+dn[i>>16&255]+dn[i>>24&255]+"-"+dn[e&255]+dn[e>>8&255]+"-"+dn[e>>16&15|64]+dn[e>>24&255]+"-"+dn[t&63|128]+dn[t>>8&255]+"-"+dn[t>>16&255]+dn[t>>24&255]+dn[n&255]+dn[n>>8&255]+dn[n>>16&255]+dn[n>>24&255]).toLowerCase()}function ct(i,e,t){return Math.max(e,Math.min(t,i))}function Mu(i,e){return(i%e+e)%e}function $0(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function X0(i,e,t){return i!==e?(t-i)/(e-i):0}function po(i,e,t){return(1-t)*i+t*e}function q0(i,e,t,n){return po(i,e,1-Math.exp(-t*n))}function Y0(i,e=1){return e-Math.abs(Mu(i,e*2)-e)}function Z0(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function K0(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function J0(i,e){return i+Math.floor(Math.random()*(e-i+1))}function j0(i,e){return i+Math.random()*(e-i)}function Q0(i){return i*(.5-Math.random())}function ev(i){i!==void 0&&(Nd=i);let e=Nd+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function tv(i){return i*fo}function nv(i){return i*Ds}function iv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function sv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Su(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function rv(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),f=o((e-n)/2),p=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*p,a*c);break;case"YXY":i.set(l*p,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*p,a*h,a*c);break;default:ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function xc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function wu(i,e){if(e.constructor===Float32Array)return i;let t=xc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Au(i,e){if(e.constructor===Float32Array)return i;let t=xc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var bc={DEG2RAD:fo,RAD2DEG:Ds,generateUUID:Mi,clamp:ct,euclideanModulo:Mu,mapLinear:$0,inverseLerp:X0,lerp:po,damp:q0,pingpong:Y0,smoothstep:Z0,smootherstep:K0,randInt:J0,randFloat:j0,randFloatSpread:Q0,seededRandom:ev,degToRad:tv,radToDeg:nv,isPowerOfTwo:iv,ceilPowerOfTwo:sv,floorPowerOfTwo:Su,setQuaternionFromProperEuler:rv,normalize:Au,denormalize:wu},it=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},kn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],p=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==f||c!==p||h!==g){let m=l*f+c*p+h*g+u*y;m<0&&(f=-f,p=-p,g=-g,y=-y,m=-m);let v=1-a;if(m<.9995){let A=Math.acos(m),S=Math.sin(A);v=Math.sin(v*A)/S,a=Math.sin(a*A)/S,l=l*v+f*a,c=c*v+p*a,h=h*v+g*a,u=u*v+y*a}else{l=l*v+f*a,c=c*v+p*a,h=h*v+g*a,u=u*v+y*a;let A=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=A,c*=A,h*=A,u*=A}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*p-c*f,e[t+1]=l*g+h*f+c*u-a*p,e[t+2]=c*g+h*p+a*f-l*u,e[t+3]=h*g-a*u-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u-f*p*g;break;case"YXZ":this._x=f*h*u+c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u+f*p*g;break;case"ZXY":this._x=f*h*u-c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u-f*p*g;break;case"ZYX":this._x=f*h*u-c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u+f*p*g;break;case"YZX":this._x=f*h*u+c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u-f*p*g;break;case"XZY":this._x=f*h*u-c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u+f*p*g;break;default:ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=n+a+u;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>u){let p=2*Math.sqrt(1+n-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>u){let p=2*Math.sqrt(1+a-n-u);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+u-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},$=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Dd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Dd.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return gh.copy(this).projectOnVector(e),this.sub(gh)}reflect(e){return this.sub(gh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},gh=new $,Dd=new kn,Je=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],p=n[5],g=n[8],y=s[0],m=s[3],v=s[6],A=s[1],S=s[4],w=s[7],T=s[2],E=s[5],x=s[8];return r[0]=o*y+a*A+l*T,r[3]=o*m+a*S+l*E,r[6]=o*v+a*w+l*x,r[1]=c*y+h*A+u*T,r[4]=c*m+h*S+u*E,r[7]=c*v+h*w+u*x,r[2]=f*y+p*A+g*T,r[5]=f*m+p*S+g*E,r[8]=f*v+p*w+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,f=a*l-h*r,p=c*r-o*l,g=t*u+n*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=f*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=p*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ps("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vh.makeScale(e,t)),this}rotate(e){return Ps("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vh.makeRotation(-e)),this}translate(e,t){return Ps("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},vh=new Je,Fd=new Je().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ud=new Je().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ov(){let i={enabled:!0,workingColorSpace:Ot,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===bt&&(s.r=Gi(s.r),s.g=Gi(s.g),s.b=Gi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===bt&&(s.r=pr(s.r),s.g=pr(s.g),s.b=pr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ns?mo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ot]:{primaries:e,whitePoint:n,transfer:mo,toXYZ:Fd,fromXYZ:Ud,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Xt},outputColorSpaceConfig:{drawingBufferColorSpace:Xt}},[Xt]:{primaries:e,whitePoint:n,transfer:bt,toXYZ:Fd,fromXYZ:Ud,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Xt}}}),i}var rt=ov();function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function pr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var er,ml=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{er===void 0&&(er=_r("canvas")),er.width=e.width,er.height=e.height;let s=er.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=er}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=_r("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gi(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Gi(t[n]/255)*255):t[n]=Gi(t[n]);return{data:t,width:e.width,height:e.height}}else return ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},av=0,xr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:av++}),this.uuid=Mi(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(_h(s[o].image)):r.push(_h(s[o]))}else r=_h(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function _h(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ml.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(ke("Texture: Unable to serialize Texture."),{})}var lv=0,yh=new $,an=class i extends _i{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Rn,s=Rn,r=Et,o=Vn,a=yt,l=Nn,c=i.DEFAULT_ANISOTROPY,h=ns){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:lv++}),this.uuid=Mi(),this.name="",this.source=new xr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Je,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(yh).x}get height(){return this.source.getSize(yh).y}get depth(){return this.source.getSize(yh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==hu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case _s:e.x=e.x-Math.floor(e.x);break;case Rn:e.x=e.x<0?0:1;break;case gr:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case _s:e.y=e.y-Math.floor(e.y);break;case Rn:e.y=e.y<0?0:1;break;case gr:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};an.DEFAULT_IMAGE=null;an.DEFAULT_MAPPING=hu;an.DEFAULT_ANISOTROPY=1;var wt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],p=l[5],g=l[9],y=l[2],m=l[6],v=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+v-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,w=(p+1)/2,T=(v+1)/2,E=(h+f)/4,x=(u+y)/4,b=(g+m)/4;return S>w&&S>T?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=E/n,r=x/n):w>T?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=E/s,r=b/s):T<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),n=x/r,s=b/r),this.set(n,s,r,t),this}let A=Math.sqrt((m-g)*(m-g)+(u-y)*(u-y)+(f-h)*(f-h));return Math.abs(A)<.001&&(A=1),this.x=(m-g)/A,this.y=(u-y)/A,this.z=(f-h)/A,this.w=Math.acos((c+p+v-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},gl=class extends _i{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Et,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new wt(0,0,e,t),this.scissorTest=!1,this.viewport=new wt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new an({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Et,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new xr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},cn=class extends gl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},vo=class extends an{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Pt,this.minFilter=Pt,this.wrapR=Rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var vl=class extends an{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Pt,this.minFilter=Pt,this.wrapR=Rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var et=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,f,p,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,f,p,g,y,m)}set(e,t,n,s,r,o,a,l,c,h,u,f,p,g,y,m){let v=this.elements;return v[0]=e,v[4]=t,v[8]=n,v[12]=s,v[1]=r,v[5]=o,v[9]=a,v[13]=l,v[2]=c,v[6]=h,v[10]=u,v[14]=f,v[3]=p,v[7]=g,v[11]=y,v[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/tr.setFromMatrixColumn(e,0).length(),r=1/tr.setFromMatrixColumn(e,1).length(),o=1/tr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let f=o*h,p=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=p+g*c,t[5]=f-y*c,t[9]=-a*l,t[2]=y-f*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*h,p=l*u,g=c*h,y=c*u;t[0]=f+y*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=p*a-g,t[6]=y+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*h,p=l*u,g=c*h,y=c*u;t[0]=f-y*a,t[4]=-o*u,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*h,t[9]=y-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*h,p=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-p,t[8]=f*c+y,t[1]=l*u,t[5]=y*c+f,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-f*u,t[8]=g*u+p,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=p*u+g,t[10]=f-y*u}else if(e.order==="XZY"){let f=o*l,p=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+y,t[5]=o*h,t[9]=p*u-g,t[2]=g*u-p,t[6]=a*h,t[10]=y*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(cv,e,hv)}lookAt(e,t,n){let s=this.elements;return Un.subVectors(e,t),Un.lengthSq()===0&&(Un.z=1),Un.normalize(),us.crossVectors(n,Un),us.lengthSq()===0&&(Math.abs(n.z)===1?Un.x+=1e-4:Un.z+=1e-4,Un.normalize(),us.crossVectors(n,Un)),us.normalize(),Da.crossVectors(Un,us),s[0]=us.x,s[4]=Da.x,s[8]=Un.x,s[1]=us.y,s[5]=Da.y,s[9]=Un.y,s[2]=us.z,s[6]=Da.z,s[10]=Un.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],p=n[13],g=n[2],y=n[6],m=n[10],v=n[14],A=n[3],S=n[7],w=n[11],T=n[15],E=s[0],x=s[4],b=s[8],L=s[12],I=s[1],F=s[5],B=s[9],z=s[13],D=s[2],W=s[6],q=s[10],K=s[14],fe=s[3],J=s[7],ae=s[11],ce=s[15];return r[0]=o*E+a*I+l*D+c*fe,r[4]=o*x+a*F+l*W+c*J,r[8]=o*b+a*B+l*q+c*ae,r[12]=o*L+a*z+l*K+c*ce,r[1]=h*E+u*I+f*D+p*fe,r[5]=h*x+u*F+f*W+p*J,r[9]=h*b+u*B+f*q+p*ae,r[13]=h*L+u*z+f*K+p*ce,r[2]=g*E+y*I+m*D+v*fe,r[6]=g*x+y*F+m*W+v*J,r[10]=g*b+y*B+m*q+v*ae,r[14]=g*L+y*z+m*K+v*ce,r[3]=A*E+S*I+w*D+T*fe,r[7]=A*x+S*F+w*W+T*J,r[11]=A*b+S*B+w*q+T*ae,r[15]=A*L+S*z+w*K+T*ce,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],p=e[14],g=e[3],y=e[7],m=e[11],v=e[15],A=l*p-c*f,S=a*p-c*u,w=a*f-l*u,T=o*p-c*h,E=o*f-l*h,x=o*u-a*h;return t*(y*A-m*S+v*w)-n*(g*A-m*T+v*E)+s*(g*S-y*T+v*x)-r*(g*w-y*E+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],p=e[11],g=e[12],y=e[13],m=e[14],v=e[15],A=t*a-n*o,S=t*l-s*o,w=t*c-r*o,T=n*l-s*a,E=n*c-r*a,x=s*c-r*l,b=h*y-u*g,L=h*m-f*g,I=h*v-p*g,F=u*m-f*y,B=u*v-p*y,z=f*v-p*m,D=A*z-S*B+w*F+T*I-E*L+x*b;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/D;return e[0]=(a*z-l*B+c*F)*W,e[1]=(s*B-n*z-r*F)*W,e[2]=(y*x-m*E+v*T)*W,e[3]=(f*E-u*x-p*T)*W,e[4]=(l*I-o*z-c*L)*W,e[5]=(t*z-s*I+r*L)*W,e[6]=(m*w-g*x-v*S)*W,e[7]=(h*x-f*w+p*S)*W,e[8]=(o*B-a*I+c*b)*W,e[9]=(n*I-t*B-r*b)*W,e[10]=(g*E-y*w+v*A)*W,e[11]=(u*w-h*E-p*A)*W,e[12]=(a*L-o*F-l*b)*W,e[13]=(t*F-n*L+s*b)*W,e[14]=(y*S-g*T-m*A)*W,e[15]=(h*T-u*S+f*A)*W,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,f=r*c,p=r*h,g=r*u,y=o*h,m=o*u,v=a*u,A=l*c,S=l*h,w=l*u,T=n.x,E=n.y,x=n.z;return s[0]=(1-(y+v))*T,s[1]=(p+w)*T,s[2]=(g-S)*T,s[3]=0,s[4]=(p-w)*E,s[5]=(1-(f+v))*E,s[6]=(m+A)*E,s[7]=0,s[8]=(g+S)*x,s[9]=(m-A)*x,s[10]=(1-(f+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=tr.set(s[0],s[1],s[2]).length(),a=tr.set(s[4],s[5],s[6]).length(),l=tr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Qn.copy(this);let c=1/o,h=1/a,u=1/l;return Qn.elements[0]*=c,Qn.elements[1]*=c,Qn.elements[2]*=c,Qn.elements[4]*=h,Qn.elements[5]*=h,Qn.elements[6]*=h,Qn.elements[8]*=u,Qn.elements[9]*=u,Qn.elements[10]*=u,t.setFromRotationMatrix(Qn),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=qn,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),f=(t+e)/(t-e),p=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===qn)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===vr)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=qn,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),f=-(t+e)/(t-e),p=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===qn)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===vr)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},tr=new $,Qn=new et,cv=new $(0,0,0),hv=new $(1,1,1),us=new $,Da=new $,Un=new $,Od=new et,Bd=new kn,Wi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Od.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Od,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Bd.setFromEuler(this),this.setFromQuaternion(Bd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Wi.DEFAULT_ORDER="XYZ";var _o=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},uv=0,kd=new $,nr=new kn,Fi=new et,Fa=new $,io=new $,fv=new $,dv=new kn,zd=new $(1,0,0),Hd=new $(0,1,0),Gd=new $(0,0,1),Vd={type:"added"},pv={type:"removed"},ir={type:"childadded",child:null},xh={type:"childremoved",child:null},zt=class i extends _i{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:uv++}),this.uuid=Mi(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new $,t=new Wi,n=new kn,s=new $(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new et},normalMatrix:{value:new Je}}),this.matrix=new et,this.matrixWorld=new et,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new _o,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return nr.setFromAxisAngle(e,t),this.quaternion.multiply(nr),this}rotateOnWorldAxis(e,t){return nr.setFromAxisAngle(e,t),this.quaternion.premultiply(nr),this}rotateX(e){return this.rotateOnAxis(zd,e)}rotateY(e){return this.rotateOnAxis(Hd,e)}rotateZ(e){return this.rotateOnAxis(Gd,e)}translateOnAxis(e,t){return kd.copy(e).applyQuaternion(this.quaternion),this.position.add(kd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(zd,e)}translateY(e){return this.translateOnAxis(Hd,e)}translateZ(e){return this.translateOnAxis(Gd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Fi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Fa.copy(e):Fa.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),io.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Fi.lookAt(io,Fa,this.up):Fi.lookAt(Fa,io,this.up),this.quaternion.setFromRotationMatrix(Fi),s&&(Fi.extractRotation(s.matrixWorld),nr.setFromRotationMatrix(Fi),this.quaternion.premultiply(nr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ke("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Vd),ir.child=e,this.dispatchEvent(ir),ir.child=null):Ke("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(pv),xh.child=e,this.dispatchEvent(xh),xh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Fi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Fi.multiply(e.parent.matrixWorld)),e.applyMatrix4(Fi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Vd),ir.child=e,this.dispatchEvent(ir),ir.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(io,e,fv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(io,dv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),f=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};zt.DEFAULT_UP=new $(0,1,0);zt.DEFAULT_MATRIX_AUTO_UPDATE=!0;zt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Bn=class extends zt{constructor(){super(),this.isGroup=!0,this.type="Group"}},mv={type:"move"},br=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Bn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Bn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new $,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new $),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Bn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new $,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new $,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),v=this._getHandJoint(c,y);m!==null&&(v.matrix.fromArray(m.transform.matrix),v.matrix.decompose(v.position,v.quaternion,v.scale),v.matrixWorldNeedsUpdate=!0,v.jointRadius=m.radius),v.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(mv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Bn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},nm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},fs={h:0,s:0,l:0},Ua={h:0,s:0,l:0};function bh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Xe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Xt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,rt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=rt.workingColorSpace){return this.r=e,this.g=t,this.b=n,rt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=rt.workingColorSpace){if(e=Mu(e,1),t=ct(t,0,1),n=ct(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=bh(o,r,e+1/3),this.g=bh(o,r,e),this.b=bh(o,r,e-1/3)}return rt.colorSpaceToWorking(this,s),this}setStyle(e,t=Xt){function n(r){r!==void 0&&parseFloat(r)<1&&ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Xt){let n=nm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gi(e.r),this.g=Gi(e.g),this.b=Gi(e.b),this}copyLinearToSRGB(e){return this.r=pr(e.r),this.g=pr(e.g),this.b=pr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Xt){return rt.workingToColorSpace(pn.copy(this),e),Math.round(ct(pn.r*255,0,255))*65536+Math.round(ct(pn.g*255,0,255))*256+Math.round(ct(pn.b*255,0,255))}getHexString(e=Xt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=rt.workingColorSpace){rt.workingToColorSpace(pn.copy(this),t);let n=pn.r,s=pn.g,r=pn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=rt.workingColorSpace){return rt.workingToColorSpace(pn.copy(this),t),e.r=pn.r,e.g=pn.g,e.b=pn.b,e}getStyle(e=Xt){rt.workingToColorSpace(pn.copy(this),e);let t=pn.r,n=pn.g,s=pn.b;return e!==Xt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(fs),this.setHSL(fs.h+e,fs.s+t,fs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(fs),e.getHSL(Ua);let n=po(fs.h,Ua.h,t),s=po(fs.s,Ua.s,t),r=po(fs.l,Ua.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},pn=new Xe;Xe.NAMES=nm;var Yn=class extends zt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Wi,this.environmentIntensity=1,this.environmentRotation=new Wi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ei=new $,Ui=new $,Mh=new $,Oi=new $,sr=new $,rr=new $,Wd=new $,Sh=new $,wh=new $,Ah=new $,Th=new wt,Eh=new wt,Rh=new wt,vs=class i{constructor(e=new $,t=new $,n=new $){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ei.subVectors(e,t),s.cross(ei);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){ei.subVectors(s,t),Ui.subVectors(n,t),Mh.subVectors(e,t);let o=ei.dot(ei),a=ei.dot(Ui),l=ei.dot(Mh),c=Ui.dot(Ui),h=Ui.dot(Mh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,p=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-p-g,g,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Oi)===null?!1:Oi.x>=0&&Oi.y>=0&&Oi.x+Oi.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Oi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Oi.x),l.addScaledVector(o,Oi.y),l.addScaledVector(a,Oi.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Th.setScalar(0),Eh.setScalar(0),Rh.setScalar(0),Th.fromBufferAttribute(e,t),Eh.fromBufferAttribute(e,n),Rh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Th,r.x),o.addScaledVector(Eh,r.y),o.addScaledVector(Rh,r.z),o}static isFrontFacing(e,t,n,s){return ei.subVectors(n,t),Ui.subVectors(e,t),ei.cross(Ui).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ei.subVectors(this.c,this.b),Ui.subVectors(this.a,this.b),ei.cross(Ui).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;sr.subVectors(s,n),rr.subVectors(r,n),Sh.subVectors(e,n);let l=sr.dot(Sh),c=rr.dot(Sh);if(l<=0&&c<=0)return t.copy(n);wh.subVectors(e,s);let h=sr.dot(wh),u=rr.dot(wh);if(h>=0&&u<=h)return t.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(sr,o);Ah.subVectors(e,r);let p=sr.dot(Ah),g=rr.dot(Ah);if(g>=0&&p<=g)return t.copy(r);let y=p*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(rr,a);let m=h*g-p*u;if(m<=0&&u-h>=0&&p-g>=0)return Wd.subVectors(r,s),a=(u-h)/(u-h+(p-g)),t.copy(s).addScaledVector(Wd,a);let v=1/(m+y+f);return o=y*v,a=f*v,t.copy(n).addScaledVector(sr,o).addScaledVector(rr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},zn=class{constructor(e=new $(1/0,1/0,1/0),t=new $(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ti.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ti.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ti.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ti):ti.fromBufferAttribute(r,o),ti.applyMatrix4(e.matrixWorld),this.expandByPoint(ti);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Oa.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Oa.copy(n.boundingBox)),Oa.applyMatrix4(e.matrixWorld),this.union(Oa)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ti),ti.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(so),Ba.subVectors(this.max,so),or.subVectors(e.a,so),ar.subVectors(e.b,so),lr.subVectors(e.c,so),ds.subVectors(ar,or),ps.subVectors(lr,ar),Es.subVectors(or,lr);let t=[0,-ds.z,ds.y,0,-ps.z,ps.y,0,-Es.z,Es.y,ds.z,0,-ds.x,ps.z,0,-ps.x,Es.z,0,-Es.x,-ds.y,ds.x,0,-ps.y,ps.x,0,-Es.y,Es.x,0];return!Ch(t,or,ar,lr,Ba)||(t=[1,0,0,0,1,0,0,0,1],!Ch(t,or,ar,lr,Ba))?!1:(ka.crossVectors(ds,ps),t=[ka.x,ka.y,ka.z],Ch(t,or,ar,lr,Ba))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ti).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ti).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Bi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Bi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Bi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Bi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Bi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Bi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Bi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Bi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Bi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Bi=[new $,new $,new $,new $,new $,new $,new $,new $],ti=new $,Oa=new zn,or=new $,ar=new $,lr=new $,ds=new $,ps=new $,Es=new $,so=new $,Ba=new $,ka=new $,Rs=new $;function Ch(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Rs.fromArray(i,r);let a=s.x*Math.abs(Rs.x)+s.y*Math.abs(Rs.y)+s.z*Math.abs(Rs.z),l=e.dot(Rs),c=t.dot(Rs),h=n.dot(Rs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Hi=gv();function gv(){let i=new ArrayBuffer(4),e=new Float32Array(i),t=new Uint32Array(i),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){let c=l-127;c<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,s[l]=-c-1,s[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,s[l]=13,s[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}let r=new Uint32Array(2048),o=new Uint32Array(64),a=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,h=0;for(;(c&8388608)===0;)c<<=1,h-=8388608;c&=-8388609,h+=947912704,r[l]=c|h}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(a[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:s,mantissaTable:r,exponentTable:o,offsetTable:a}}function vv(i){Math.abs(i)>65504&&ke("DataUtils.toHalfFloat(): Value out of range."),i=ct(i,-65504,65504),Hi.floatView[0]=i;let e=Hi.uint32View[0],t=e>>23&511;return Hi.baseTable[t]+((e&8388607)>>Hi.shiftTable[t])}function _v(i){let e=i>>10;return Hi.uint32View[0]=Hi.mantissaTable[Hi.offsetTable[e]+(i&1023)]+Hi.exponentTable[e],Hi.floatView[0]}var xe=class{static toHalfFloat(e){return vv(e)}static fromHalfFloat(e){return _v(e)}},en=new $,za=new it,yv=0,ut=class extends _i{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:yv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=bu,this.updateRanges=[],this.gpuType=_t,this.version=0,this._normalizationScale=e!==void 0?xc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)za.fromBufferAttribute(this,t),za.applyMatrix3(e),this.setXY(t,za.x,za.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.applyMatrix3(e),this.setXYZ(t,en.x,en.y,en.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.applyMatrix4(e),this.setXYZ(t,en.x,en.y,en.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.applyNormalMatrix(e),this.setXYZ(t,en.x,en.y,en.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.transformDirection(e),this.setXYZ(t,en.x,en.y,en.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):wu(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Au(e,this.array)}},yo=class extends ut{constructor(e,t,n){super(new Int8Array(e),t,n)}},xo=class extends ut{constructor(e,t,n){super(new Uint8Array(e),t,n)}};var bo=class extends ut{constructor(e,t,n){super(new Int16Array(e),t,n)}},Fs=class extends ut{constructor(e,t,n){super(new Uint16Array(e),t,n)}},Mo=class extends ut{constructor(e,t,n){super(new Int32Array(e),t,n)}},Us=class extends ut{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var kt=class extends ut{constructor(e,t,n){super(new Float32Array(e),t,n)}},xv=new zn,ro=new $,Ih=new $,Cn=class{constructor(e=new $,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):xv.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ro.subVectors(e,this.center);let t=ro.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ro,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ih.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ro.copy(e.center).add(Ih)),this.expandByPoint(ro.copy(e.center).sub(Ih))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},bv=0,Xn=new et,Ph=new zt,cr=new $,On=new zn,oo=new zn,on=new $,Lt=class i extends _i{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:bv++}),this.uuid=Mi(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(V0(e)?Us:Fs)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Je().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Xn.makeRotationFromQuaternion(e),this.applyMatrix4(Xn),this}rotateX(e){return Xn.makeRotationX(e),this.applyMatrix4(Xn),this}rotateY(e){return Xn.makeRotationY(e),this.applyMatrix4(Xn),this}rotateZ(e){return Xn.makeRotationZ(e),this.applyMatrix4(Xn),this}translate(e,t,n){return Xn.makeTranslation(e,t,n),this.applyMatrix4(Xn),this}scale(e,t,n){return Xn.makeScale(e,t,n),this.applyMatrix4(Xn),this}lookAt(e){return Ph.lookAt(e),Ph.updateMatrix(),this.applyMatrix4(Ph.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(cr).negate(),this.translate(cr.x,cr.y,cr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new kt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new $(-1/0,-1/0,-1/0),new $(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];On.setFromBufferAttribute(r),this.morphTargetsRelative?(on.addVectors(this.boundingBox.min,On.min),this.boundingBox.expandByPoint(on),on.addVectors(this.boundingBox.max,On.max),this.boundingBox.expandByPoint(on)):(this.boundingBox.expandByPoint(On.min),this.boundingBox.expandByPoint(On.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ke('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Cn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ke("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new $,1/0);return}if(e){let n=this.boundingSphere.center;if(On.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];oo.setFromBufferAttribute(a),this.morphTargetsRelative?(on.addVectors(On.min,oo.min),On.expandByPoint(on),on.addVectors(On.max,oo.max),On.expandByPoint(on)):(On.expandByPoint(oo.min),On.expandByPoint(oo.max))}On.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)on.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(on));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)on.fromBufferAttribute(a,c),l&&(cr.fromBufferAttribute(e,c),on.add(cr)),s=Math.max(s,n.distanceToSquared(on))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ke('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ke("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new ut(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let L=0;L<n.count;L++)a[L]=new $,l[L]=new $;let h=new $,u=new $,f=new $,p=new it,g=new it,y=new it,m=new $,v=new $;function A(L,I,F){c[L]=c[I]=c[F]=1,h.fromBufferAttribute(n,L),u.fromBufferAttribute(n,I),f.fromBufferAttribute(n,F),p.fromBufferAttribute(r,L),g.fromBufferAttribute(r,I),y.fromBufferAttribute(r,F),u.sub(h),f.sub(h),g.sub(p),y.sub(p);let B=1/(g.x*y.y-y.x*g.y);isFinite(B)&&(m.copy(u).multiplyScalar(y.y).addScaledVector(f,-g.y).multiplyScalar(B),v.copy(f).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(B),a[L].add(m),a[I].add(m),a[F].add(m),l[L].add(v),l[I].add(v),l[F].add(v))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let L=0,I=S.length;L<I;++L){let F=S[L],B=F.start,z=F.count;for(let D=B,W=B+z;D<W;D+=3)A(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let w=new $,T=new $,E=new $,x=new $;function b(L){E.fromBufferAttribute(s,L),x.copy(E);let I=a[L];w.copy(I),w.sub(E.multiplyScalar(E.dot(I))).normalize(),T.crossVectors(x,I);let B=T.dot(l[L])<0?-1:1;o.setXYZW(L,w.x,w.y,w.z,B)}for(let L=0,I=n.count;L<I;++L)c[L]&&b(L);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new ut(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let s=new $,r=new $,o=new $,a=new $,l=new $,c=new $,h=new $,u=new $;if(e)for(let f=0,p=e.count;f<p;f+=3){let g=e.getX(f+0),y=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)on.fromBufferAttribute(e,t),on.normalize(),e.setXYZ(t,on.x,on.y,on.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),p=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?p=l[y]*a.data.stride+a.offset:p=l[y]*h;for(let v=0;v<h;v++)f[g++]=c[p++]}return new ut(f,h,u)}if(this.index===null)return ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],p=e(f,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let p=c[u];h.push(p.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,p=u.length;f<p;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Mr=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=bu,this.updateRanges=[],this.version=0,this.uuid=Mi()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=$d(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=$d(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function $d(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Mi()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Mn=new $,Sr=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?xc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix4(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyNormalMatrix(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.transformDirection(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){go("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new ut(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){go("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):wu(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Au(e,this.data.array)}},Lh=new $,Mv=new $,Sv=new Je,ni=class{constructor(e=new $(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Lh.subVectors(n,t).cross(Mv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Lh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Sv.getNormalMatrix(e),s=this.coplanarPoint(Lh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},wv=0,In=class extends _i{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:wv++}),this.uuid=Mi(),this.name="",this.type="Material",this.blending=Pr,this.side=Zn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=iu,this.blendDst=su,this.blendEquation=Gs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xe(0,0,0),this.blendAlpha=0,this.depthFunc=mr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=al,this.stencilZFail=al,this.stencilZPass=al,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Xe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ni().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new it().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ki=new $,Nh=new $,Ha=new $,Ga=new $,Os=class{constructor(e=new $,t=new $(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ki)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ki.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ki.copy(this.origin).addScaledVector(this.direction,t),ki.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Nh.copy(e).add(t).multiplyScalar(.5),Ha.copy(t).sub(e).normalize(),Ga.copy(this.origin).sub(Nh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ha),a=Ga.dot(this.direction),l=-Ga.dot(Ha),c=Ga.lengthSq(),h=Math.abs(1-o*o),u,f,p,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let y=1/h;u*=y,f*=y,p=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Nh).addScaledVector(Ha,f),p}intersectSphere(e,t){if(e.radius<0)return null;ki.subVectors(e.center,this.origin);let n=ki.dot(this.direction),s=ki.dot(ki)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(a=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ki)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,f=e.y-o.y,p=e.z-o.z,g=t.x-o.x,y=t.y-o.y,m=t.z-o.z,v=n.x-o.x,A=n.y-o.y,S=n.z-o.z,w=Math.abs(l),T=Math.abs(c),E=Math.abs(h),x,b,L,I,F,B,z,D,W,q,K,fe;if(w>=T&&w>=E?(L=l,B=u,W=g,fe=v,l>=0?(x=c,b=h,I=f,F=p,z=y,D=m,q=A,K=S):(x=h,b=c,I=p,F=f,z=m,D=y,q=S,K=A)):T>=E?(L=c,B=f,W=y,fe=A,c>=0?(x=h,b=l,I=p,F=u,z=m,D=g,q=S,K=v):(x=l,b=h,I=u,F=p,z=g,D=m,q=v,K=S)):(L=h,B=p,W=m,fe=S,h>=0?(x=l,b=c,I=u,F=f,z=g,D=y,q=v,K=A):(x=c,b=l,I=f,F=u,z=y,D=g,q=A,K=v)),L===0)return null;let J=x/L,ae=b/L,ce=1/L,we=I-J*B,De=F-ae*B,ie=z-J*W,Re=D-ae*W,Ue=q-J*fe,ze=K-ae*fe,me=Ue*Re-ze*ie,$e=we*ze-De*Ue,Mt=ie*De-Re*we;if(s){if(me<0||$e<0||Mt<0)return null}else if((me<0||$e<0||Mt<0)&&(me>0||$e>0||Mt>0))return null;let Ve=me+$e+Mt;if(Ve===0)return null;let ft=ce*(me*B+$e*W+Mt*fe);return(Ve>0?ft<0:ft>0)?null:this.at(ft/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ii=class extends In{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Wi,this.combine=ru,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Xd=new et,Cs=new Os,Va=new Cn,qd=new $,Wa=new $,$a=new $,Xa=new $,Dh=new $,qa=new $,Yd=new $,Ya=new $,At=class extends zt{constructor(e=new Lt,t=new ii){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){qa.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Dh.fromBufferAttribute(u,e),o?qa.addScaledVector(Dh,h):qa.addScaledVector(Dh.sub(t),h))}t.add(qa)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Va.copy(n.boundingSphere),Va.applyMatrix4(r),Cs.copy(e.ray).recast(e.near),!(Va.containsPoint(Cs.origin)===!1&&(Cs.intersectSphere(Va,qd)===null||Cs.origin.distanceToSquared(qd)>(e.far-e.near)**2))&&(Xd.copy(r).invert(),Cs.copy(e.ray).applyMatrix4(Xd),!(n.boundingBox!==null&&Cs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Cs)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let m=f[g],v=o[m.materialIndex],A=Math.max(m.start,p.start),S=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let w=A,T=S;w<T;w+=3){let E=a.getX(w),x=a.getX(w+1),b=a.getX(w+2);s=Za(this,v,e,n,c,h,u,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(a.count,p.start+p.count);for(let m=g,v=y;m<v;m+=3){let A=a.getX(m),S=a.getX(m+1),w=a.getX(m+2);s=Za(this,o,e,n,c,h,u,A,S,w),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let m=f[g],v=o[m.materialIndex],A=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let w=A,T=S;w<T;w+=3){let E=w,x=w+1,b=w+2;s=Za(this,v,e,n,c,h,u,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(l.count,p.start+p.count);for(let m=g,v=y;m<v;m+=3){let A=m,S=m+1,w=m+2;s=Za(this,o,e,n,c,h,u,A,S,w),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Av(i,e,t,n,s,r,o,a){let l;if(e.side===hn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Zn,a),l===null)return null;Ya.copy(a),Ya.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Ya);return c<t.near||c>t.far?null:{distance:c,point:Ya.clone(),object:i}}function Za(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Wa),i.getVertexPosition(l,$a),i.getVertexPosition(c,Xa);let h=Av(i,e,t,n,Wa,$a,Xa,Yd);if(h){let u=new $;vs.getBarycoord(Yd,Wa,$a,Xa,u),s&&(h.uv=vs.getInterpolatedAttribute(s,a,l,c,u,new it)),r&&(h.uv1=vs.getInterpolatedAttribute(r,a,l,c,u,new it)),o&&(h.normal=vs.getInterpolatedAttribute(o,a,l,c,u,new $),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new $,materialIndex:0};vs.getNormal(Wa,$a,Xa,f.normal),h.face=f,h.barycoord=u}return h}var ao=new wt,Zd=new wt,Kd=new wt,Tv=new wt,Jd=new et,Ka=new $,Fh=new Cn,jd=new et,Uh=new Os,So=class extends At{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Hh,this.bindMatrix=new et,this.bindMatrixInverse=new et,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new zn),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Ka),this.boundingBox.expandByPoint(Ka)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new Cn),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Ka),this.boundingSphere.expandByPoint(Ka)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,s=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Fh.copy(this.boundingSphere),Fh.applyMatrix4(s),e.ray.intersectsSphere(Fh)!==!1&&(jd.copy(s).invert(),Uh.copy(e.ray).applyMatrix4(jd),!(this.boundingBox!==null&&Uh.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,Uh)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new wt,t=this.geometry.attributes.skinWeight;for(let n=0,s=t.count;n<s;n++){e.fromBufferAttribute(t,n);let r=1/e.manhattanLength();r!==1/0?e.multiplyScalar(r):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===Hh?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===Gp?this.bindMatrixInverse.copy(this.bindMatrix).invert():ke("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,s=this.geometry;Zd.fromBufferAttribute(s.attributes.skinIndex,e),Kd.fromBufferAttribute(s.attributes.skinWeight,e),t.isVector4?(ao.copy(t),t.set(0,0,0,0)):(ao.set(t.x,t.y,t.z,1),t.set(0,0,0)),ao.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=Kd.getComponent(r);if(o!==0){let a=Zd.getComponent(r);Jd.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(Tv.copy(ao).applyMatrix4(Jd),o)}}return t.isVector4&&(t.w=ao.w),t.applyMatrix4(this.bindMatrixInverse)}},wr=class extends zt{constructor(){super(),this.isBone=!0,this.type="Bone"}},mn=class extends an{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Pt,h=Pt,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},Qd=new et,Ev=new et,wo=class i{constructor(e=[],t=[]){this.uuid=Mi(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){ke("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,s=this.bones.length;n<s;n++)this.boneInverses.push(new et)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new et;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,s=this.boneTexture;for(let r=0,o=e.length;r<o;r++){let a=e[r]?e[r].matrixWorld:Ev;Qd.multiplyMatrices(a,t[r]),Qd.toArray(n,r*16)}s!==null&&(s.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new mn(t,e,e,yt,_t);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let s=this.bones[t];if(s.name===e)return s}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,s=e.bones.length;n<s;n++){let r=e.bones[n],o=t[r];o===void 0&&(ke("Skeleton: No bone found with UUID:",r),o=new wr),this.bones.push(o),this.boneInverses.push(new et().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let s=0,r=t.length;s<r;s++){let o=t[s];e.bones.push(o.uuid);let a=n[s];e.boneInverses.push(a.toArray())}return e}},$i=class extends ut{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},hr=new et,ep=new et,Ja=[],tp=new zn,Rv=new et,lo=new At,co=new Cn,Ao=class extends At{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new $i(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Rv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new zn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,hr),tp.copy(e.boundingBox).applyMatrix4(hr),this.boundingBox.union(tp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Cn),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,hr),co.copy(e.boundingSphere).applyMatrix4(hr),this.boundingSphere.union(co)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(lo.geometry=this.geometry,lo.material=this.material,lo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),co.copy(this.boundingSphere),co.applyMatrix4(n),e.ray.intersectsSphere(co)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,hr),ep.multiplyMatrices(n,hr),lo.matrixWorld=ep,lo.raycast(e,Ja);for(let o=0,a=Ja.length;o<a;o++){let l=Ja[o];l.instanceId=r,l.object=this,t.push(l)}Ja.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new $i(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new mn(new Float32Array(s*this.count),s,this.count,ts,_t));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Is=new Cn,Cv=new it(.5,.5),ja=new $,ys=class{constructor(e=new ni,t=new ni,n=new ni,s=new ni,r=new ni,o=new ni){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=qn,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],p=r[7],g=r[8],y=r[9],m=r[10],v=r[11],A=r[12],S=r[13],w=r[14],T=r[15];if(s[0].setComponents(c-o,p-h,v-g,T-A).normalize(),s[1].setComponents(c+o,p+h,v+g,T+A).normalize(),s[2].setComponents(c+a,p+u,v+y,T+S).normalize(),s[3].setComponents(c-a,p-u,v-y,T-S).normalize(),n)s[4].setComponents(l,f,m,w).normalize(),s[5].setComponents(c-l,p-f,v-m,T-w).normalize();else if(s[4].setComponents(c-l,p-f,v-m,T-w).normalize(),t===qn)s[5].setComponents(c+l,p+f,v+m,T+w).normalize();else if(t===vr)s[5].setComponents(l,f,m,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Is.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Is.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Is)}intersectsSprite(e){Is.center.set(0,0,0);let t=Cv.distanceTo(e.center);return Is.radius=.7071067811865476+t,Is.applyMatrix4(e.matrixWorld),this.intersectsSphere(Is)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(ja.x=s.normal.x>0?e.max.x:e.min.x,ja.y=s.normal.y>0?e.max.y:e.min.y,ja.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ja)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},np=new et,_l=class i{constructor(){this.coordinateSystem=qn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];np.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ys),n[s].setFromProjectionMatrix(np,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ys),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Xi=class extends In{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Xe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},yl=new $,xl=new $,ip=new et,ho=new Os,Qa=new Cn,Oh=new $,sp=new $,yi=class extends zt{constructor(e=new Lt,t=new Xi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)yl.fromBufferAttribute(t,s-1),xl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=yl.distanceTo(xl);e.setAttribute("lineDistance",new kt(n,1))}else ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Qa.copy(n.boundingSphere),Qa.applyMatrix4(s),Qa.radius+=r,e.ray.intersectsSphere(Qa)===!1)return;ip.copy(s).invert(),ho.copy(e.ray).applyMatrix4(ip);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=p,m=g-1;y<m;y+=c){let v=h.getX(y),A=h.getX(y+1),S=el(this,e,ho,l,v,A,y);S&&t.push(S)}if(this.isLineLoop){let y=h.getX(g-1),m=h.getX(p),v=el(this,e,ho,l,y,m,g-1);v&&t.push(v)}}else{let p=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let y=p,m=g-1;y<m;y+=c){let v=el(this,e,ho,l,y,y+1,y);v&&t.push(v)}if(this.isLineLoop){let y=el(this,e,ho,l,g-1,p,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function el(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(yl.fromBufferAttribute(a,s),xl.fromBufferAttribute(a,r),t.distanceSqToSegment(yl,xl,Oh,sp)>n)return;Oh.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Oh);if(!(c<e.near||c>e.far))return{distance:c,point:sp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var rp=new $,op=new $,To=class extends yi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)rp.fromBufferAttribute(t,s),op.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+rp.distanceTo(op);e.setAttribute("lineDistance",new kt(n,1))}else ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Bs=class extends yi{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Ar=class extends In{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Xe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},ap=new et,Xh=new Os,tl=new Cn,nl=new $,Eo=class extends zt{constructor(e=new Lt,t=new Ar){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),tl.copy(n.boundingSphere),tl.applyMatrix4(s),tl.radius+=r,e.ray.intersectsSphere(tl)===!1)return;ap.copy(s).invert(),Xh.copy(e.ray).applyMatrix4(ap);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let f=Math.max(0,o.start),p=Math.min(c.count,o.start+o.count);for(let g=f,y=p;g<y;g++){let m=c.getX(g);nl.fromBufferAttribute(u,m),lp(nl,m,l,s,e,t,this)}}else{let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let g=f,y=p;g<y;g++)nl.fromBufferAttribute(u,g),lp(nl,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function lp(i,e,t,n,s,r,o){let a=Xh.distanceSqToPoint(i);if(a<t){let l=new $;Xh.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Ro=class extends an{constructor(e=[],t=Vs,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var qi=class extends an{constructor(e,t,n=ri,s,r,o,a=Pt,l=Pt,c,h=Vi,u=1){if(h!==Vi&&h!==es)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new xr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Co=class extends qi{constructor(e,t=ri,n=Vs,s,r,o=Pt,a=Pt,l,c=Vi){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Io=class extends an{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Tr=class i extends Lt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,p=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new kt(c,3)),this.setAttribute("normal",new kt(h,3)),this.setAttribute("uv",new kt(u,2));function g(y,m,v,A,S,w,T,E,x,b,L){let I=w/x,F=T/b,B=w/2,z=T/2,D=E/2,W=x+1,q=b+1,K=0,fe=0,J=new $;for(let ae=0;ae<q;ae++){let ce=ae*F-z;for(let we=0;we<W;we++){let De=we*I-B;J[y]=De*A,J[m]=ce*S,J[v]=D,c.push(J.x,J.y,J.z),J[y]=0,J[m]=0,J[v]=E>0?1:-1,h.push(J.x,J.y,J.z),u.push(we/x),u.push(1-ae/b),K+=1}}for(let ae=0;ae<b;ae++)for(let ce=0;ce<x;ce++){let we=f+ce+W*ae,De=f+ce+W*(ae+1),ie=f+(ce+1)+W*(ae+1),Re=f+(ce+1)+W*ae;l.push(we,De,Re),l.push(De,ie,Re),fe+=6}a.addGroup(p,fe,L),p+=fe,f+=K}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var bl=class i extends Lt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],p=[],g=0,y=[],m=n/2,v=0;A(),o===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new kt(u,3)),this.setAttribute("normal",new kt(f,3)),this.setAttribute("uv",new kt(p,2));function A(){let w=new $,T=new $,E=0,x=(t-e)/n;for(let b=0;b<=r;b++){let L=[],I=b/r,F=I*(t-e)+e;for(let B=0;B<=s;B++){let z=B/s,D=z*l+a,W=Math.sin(D),q=Math.cos(D);T.x=F*W,T.y=-I*n+m,T.z=F*q,u.push(T.x,T.y,T.z),w.set(W,x,q).normalize(),f.push(w.x,w.y,w.z),p.push(z,1-I),L.push(g++)}y.push(L)}for(let b=0;b<s;b++)for(let L=0;L<r;L++){let I=y[L][b],F=y[L+1][b],B=y[L+1][b+1],z=y[L][b+1];(e>0||L!==0)&&(h.push(I,F,z),E+=3),(t>0||L!==r-1)&&(h.push(F,B,z),E+=3)}c.addGroup(v,E,0),v+=E}function S(w){let T=g,E=new it,x=new $,b=0,L=w===!0?e:t,I=w===!0?1:-1;for(let B=1;B<=s;B++)u.push(0,m*I,0),f.push(0,I,0),p.push(.5,.5),g++;let F=g;for(let B=0;B<=s;B++){let D=B/s*l+a,W=Math.cos(D),q=Math.sin(D);x.x=L*q,x.y=m*I,x.z=L*W,u.push(x.x,x.y,x.z),f.push(0,I,0),E.x=W*.5+.5,E.y=q*.5*I+.5,p.push(E.x,E.y),g++}for(let B=0;B<s;B++){let z=T+B,D=F+B;w===!0?h.push(D,D+1,z):h.push(D+1,D,z),b+=3}c.addGroup(v,b,w===!0?1:2),v+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ml=class i extends bl{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var si=class i extends Lt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,f=t/l,p=[],g=[],y=[],m=[];for(let v=0;v<h;v++){let A=v*f-o;for(let S=0;S<c;S++){let w=S*u-r;g.push(w,-A,0),y.push(0,0,1),m.push(S/a),m.push(1-v/l)}}for(let v=0;v<l;v++)for(let A=0;A<a;A++){let S=A+c*v,w=A+c*(v+1),T=A+1+c*(v+1),E=A+1+c*v;p.push(S,w,E),p.push(w,T,E)}this.setIndex(p),this.setAttribute("position",new kt(g,3)),this.setAttribute("normal",new kt(y,3)),this.setAttribute("uv",new kt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Po=class i extends Lt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new $,f=new $,p=[],g=[],y=[],m=[];for(let v=0;v<=n;v++){let A=[],S=v/n,w=o+S*a,T=e*Math.cos(w),E=Math.sqrt(e*e-T*T),x=0;v===0&&o===0?x=.5/t:v===n&&l===Math.PI&&(x=-.5/t);for(let b=0;b<=t;b++){let L=b/t,I=s+L*r;u.x=-E*Math.cos(I),u.y=T,u.z=E*Math.sin(I),g.push(u.x,u.y,u.z),f.copy(u).normalize(),y.push(f.x,f.y,f.z),m.push(L+x,1-S),A.push(c++)}h.push(A)}for(let v=0;v<n;v++)for(let A=0;A<t;A++){let S=h[v][A+1],w=h[v][A],T=h[v+1][A],E=h[v+1][A+1];(v!==0||o>0)&&p.push(S,w,E),(v!==n-1||l<Math.PI)&&p.push(w,T,E)}this.setIndex(p),this.setAttribute("position",new kt(g,3)),this.setAttribute("normal",new kt(y,3)),this.setAttribute("uv",new kt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Xs(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(cp(s))s.isRenderTargetTexture?(ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(cp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function gn(i){let e={};for(let t=0;t<i.length;t++){let n=Xs(i[t]);for(let s in n)e[s]=n[s]}return e}function cp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Iv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Tu(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:rt.workingColorSpace}var im={clone:Xs,merge:gn},Pv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Lv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ht=class extends In{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Pv,this.fragmentShader=Lv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Xs(e.uniforms),this.uniformsGroups=Iv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Xe().setHex(s.value);break;case"v2":this.uniforms[n].value=new it().fromArray(s.value);break;case"v3":this.uniforms[n].value=new $().fromArray(s.value);break;case"v4":this.uniforms[n].value=new wt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Je().fromArray(s.value);break;case"m4":this.uniforms[n].value=new et().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Sl=class extends Ht{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ks=class extends In{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Xe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=yc,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Wi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Sn=class extends ks{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new it(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return ct(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new Xe(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new Xe(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new Xe(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Ps('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Ps('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var wl=class extends In{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Wp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Al=class extends In{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function gs(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function uo(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function Nv(i){function e(s,r){return i[s]-i[r]}let t=i.length,n=new Array(t);for(let s=0;s!==t;++s)n[s]=s;return n.sort(e),n}function hp(i,e,t){let n=i.length,s=new i.constructor(n);for(let r=0,o=0;o!==n;++r){let a=t[r]*e;for(let l=0;l!==e;++l)s[o++]=i[a+l]}return s}function Dv(i,e,t,n){let s=1,r=i[0];for(;r!==void 0&&r[n]===void 0;)r=i[s++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(e.push(r.time),t.push(...o)),r=i[s++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(e.push(r.time),o.toArray(t,t.length)),r=i[s++];while(r!==void 0);else do o=r[n],o!==void 0&&(e.push(r.time),t.push(o)),r=i[s++];while(r!==void 0)}var xi=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break t}o=n,n=0;break n}break e}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Tl=class extends xi{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Vh,endingEnd:Vh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wh:r=e,a=2*t-n;break;case $h:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Wh:o=e,l=2*n-t;break;case $h:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(n-t)/(s-t),y=g*g,m=y*g,v=-f*m+2*f*y-f*g,A=(1+f)*m+(-1.5-2*f)*y+(-.5+f)*g+1,S=(-1-p)*m+(1.5+p)*y+.5*g,w=p*m-p*y;for(let T=0;T!==a;++T)r[T]=v*o[h+T]+A*o[c+T]+S*o[l+T]+w*o[u+T];return r}},El=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Rl=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Cl=class extends xi{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),y=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*g;return r}let f=a*2,p=e-1;for(let g=0;g!==a;++g){let y=o[c+g],m=o[l+g],v=p*f+g*2,A=u[v],S=u[v+1],w=e*f+g*2,T=h[w],E=h[w+1],x=Uv(n,t,A,T,s);r[g]=sm(x,y,S,E,m)}return r}};function sm(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Fv(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Uv(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=sm(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Fv(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Pn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=gs(t,this.TimeBufferType),this.values=gs(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:gs(e.times,Array),values:gs(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),uo(e.settings)&&(n.settings={inTangents:gs(e.settings.inTangents,Array),outTangents:gs(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Rl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new El(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Tl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Cl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ls:t=this.InterpolantFactoryMethodDiscrete;break;case Ns:t=this.InterpolantFactoryMethodLinear;break;case ol:t=this.InterpolantFactoryMethodSmooth;break;case Gh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ls;case this.InterpolantFactoryMethodLinear:return Ns;case this.InterpolantFactoryMethodSmooth:return ol;case this.InterpolantFactoryMethodBezier:return Gh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;uo(this.settings)&&(up(this.settings.inTangents,e),up(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;uo(this.settings)&&(fp(this.settings.inTangents,e),fp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ke("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ke("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ke("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ke("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&W0(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ke("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ol,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,f=u-n,p=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[f+g]||y!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,f=o*n;for(let p=0;p!==n;++p)t[f+p]=t[u+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,uo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function up(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function fp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Pn.prototype.ValueTypeName="";Pn.prototype.TimeBufferType=Float32Array;Pn.prototype.ValueBufferType=Float32Array;Pn.prototype.DefaultInterpolation=Ns;var Yi=class extends Pn{constructor(e,t,n){super(e,t,n)}};Yi.prototype.ValueTypeName="bool";Yi.prototype.ValueBufferType=Array;Yi.prototype.DefaultInterpolation=Ls;Yi.prototype.InterpolantFactoryMethodLinear=void 0;Yi.prototype.InterpolantFactoryMethodSmooth=void 0;var Lo=class extends Pn{constructor(e,t,n,s){super(e,t,n,s)}};Lo.prototype.ValueTypeName="color";var Zi=class extends Pn{constructor(e,t,n,s){super(e,t,n,s)}};Zi.prototype.ValueTypeName="number";var Il=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)kn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ki=class extends Pn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Il(this.times,this.values,this.getValueSize(),e)}};Ki.prototype.ValueTypeName="quaternion";Ki.prototype.InterpolantFactoryMethodSmooth=void 0;var Ji=class extends Pn{constructor(e,t,n){super(e,t,n)}};Ji.prototype.ValueTypeName="string";Ji.prototype.ValueBufferType=Array;Ji.prototype.DefaultInterpolation=Ls;Ji.prototype.InterpolantFactoryMethodLinear=void 0;Ji.prototype.InterpolantFactoryMethodSmooth=void 0;var xs=class extends Pn{constructor(e,t,n,s){super(e,t,n,s)}};xs.prototype.ValueTypeName="vector";var No=class{constructor(e="",t=-1,n=[],s=Vp){this.name=e,this.tracks=n,this.duration=t,this.blendMode=s,this.uuid=Mi(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,s=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push(Bv(n[o]).scale(s));let r=new this(e.name,e.duration,t,e.blendMode);return r.uuid=e.uuid,r.userData=JSON.parse(e.userData||"{}"),r}static toJSON(e){let t=[],n=e.tracks,s={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let r=0,o=n.length;r!==o;++r)t.push(Pn.toJSON(n[r]));return s}static CreateFromMorphTargetSequence(e,t,n,s){let r=t.length,o=[];for(let a=0;a<r;a++){let l=[],c=[];l.push((a+r-1)%r,a,(a+1)%r),c.push(0,1,0);let h=Nv(l);l=hp(l,1,h),c=hp(c,1,h),!s&&l[0]===0&&(l.push(r),c.push(c[0])),o.push(new Zi(".morphTargetInfluences["+t[a].name+"]",l,c).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let s=e;n=s.geometry&&s.geometry.animations||s.animations}for(let s=0;s<n.length;s++)if(n[s].name===t)return n[s];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let s={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,l=e.length;a<l;a++){let c=e[a],h=c.name.match(r);if(h&&h.length>1){let u=h[1],f=s[u];f||(s[u]=f=[]),f.push(c)}}let o=[];for(let a in s)o.push(this.CreateFromMorphTargetSequence(a,s[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,s=e.length;n!==s;++n){let r=this.tracks[n];t=Math.max(t,r.times[r.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function Ov(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Zi;case"vector":case"vector2":case"vector3":case"vector4":return xs;case"color":return Lo;case"quaternion":return Ki;case"bool":case"boolean":return Yi;case"string":return Ji}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function Bv(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=Ov(i.type);if(i.times===void 0){let n=[],s=[];Dv(i.keys,n,s,"value"),i.times=n,i.values=s}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),uo(i.settings)&&(t.settings={inTangents:gs(i.settings.inTangents,Float32Array),outTangents:gs(i.settings.outTangents,Float32Array)}),t}var vi={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(dp(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!dp(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function dp(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Pl=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let p=c[u],g=c[u+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},rm=new Pl,Hn=class{constructor(e){this.manager=e!==void 0?e:rm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Hn.DEFAULT_MATERIAL_NAME="__DEFAULT";var zi={},qh=class extends Error{constructor(e,t){super(e),this.response=t}},ji=class extends Hn{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=vi.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(zi[e]!==void 0){zi[e].push({onLoad:t,onProgress:n,onError:s});return}zi[e]=[],zi[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&ke("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let h=zi[e],u=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),p=f?parseInt(f):0,g=p!==0,y=0,m=new ReadableStream({start(v){A();function A(){u.read().then(({done:S,value:w})=>{if(S)v.close();else{y+=w.byteLength;let T=new ProgressEvent("progress",{lengthComputable:g,loaded:y,total:p});for(let E=0,x=h.length;E<x;E++){let b=h[E];b.onProgress&&b.onProgress(T)}v.enqueue(w),A()}},S=>{v.error(S)})}}});return new Response(m)}else throw new qh(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return c.json();default:if(a==="")return c.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),f=u&&u[1]?u[1].toLowerCase():void 0,p=new TextDecoder(f);return c.arrayBuffer().then(g=>p.decode(g))}}}).then(c=>{vi.add(`file:${e}`,c);let h=zi[e];delete zi[e];for(let u=0,f=h.length;u<f;u++){let p=h[u];p.onLoad&&p.onLoad(c)}}).catch(c=>{let h=zi[e];if(h===void 0)throw this.manager.itemError(e),c;delete zi[e];for(let u=0,f=h.length;u<f;u++){let p=h[u];p.onError&&p.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var ur=new WeakMap,Ll=class extends Hn{constructor(e){super(e)}load(e,t,n,s){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=vi.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(e),setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);else{let u=ur.get(o);u===void 0&&(u=[],ur.set(o,u)),u.push({onLoad:t,onError:s})}return o}let a=_r("img");function l(){h(),t&&t(this);let u=ur.get(this)||[];for(let f=0;f<u.length;f++){let p=u[f];p.onLoad&&p.onLoad(this)}ur.delete(this),r.manager.itemEnd(e)}function c(u){h(),s&&s(u),vi.remove(`image:${e}`);let f=ur.get(this)||[];for(let p=0;p<f.length;p++){let g=f[p];g.onError&&g.onError(u)}ur.delete(this),r.manager.itemError(e),r.manager.itemEnd(e)}function h(){a.removeEventListener("load",l,!1),a.removeEventListener("error",c,!1)}return a.addEventListener("load",l,!1),a.addEventListener("error",c,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),vi.add(`image:${e}`,a),r.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var zs=class extends Hn{constructor(e){super(e)}load(e,t,n,s){let r=this,o=new mn,a=new ji(this.manager);return a.setPriority(this.priority),a.setCache(this.cache),a.setResponseType("arraybuffer"),a.setRequestHeader(this.requestHeader),a.setPath(this.path),a.setWithCredentials(r.withCredentials),a.load(e,function(l){let c;try{c=r.parse(l)}catch(h){s!==void 0?s(h):Ke(h);return}r._applyTexData(o,c),t&&t(o,c)},n,s),o}createDataTexture(e){let t=new mn;return this._applyTexData(t,this.parse(e)),t}_applyTexData(e,t){t.image!==void 0?e.image=t.image:t.data!==void 0&&(e.image.width=t.width,e.image.height=t.height,e.image.data=t.data),e.wrapS=t.wrapS!==void 0?t.wrapS:Rn,e.wrapT=t.wrapT!==void 0?t.wrapT:Rn,e.magFilter=t.magFilter!==void 0?t.magFilter:Et,e.minFilter=t.minFilter!==void 0?t.minFilter:Et,e.anisotropy=t.anisotropy!==void 0?t.anisotropy:1,t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.mipmaps!==void 0&&(e.mipmaps=t.mipmaps,e.minFilter=Vn),t.mipmapCount===1&&(e.minFilter=Et),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),e.needsUpdate=!0}},Do=class extends Hn{constructor(e){super(e)}load(e,t,n,s){let r=new an,o=new Ll(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){r.image=a,r.needsUpdate=!0,t!==void 0&&t(r)},n,s),r}},Er=class extends zt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Xe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Bh=new et,pp=new $,mp=new $,Rr=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new it(512,512),this.mapType=Nn,this.map=null,this.mapPass=null,this.matrix=new et,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ys,this._frameExtents=new it(1,1),this._viewportCount=1,this._viewports=[new wt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;pp.setFromMatrixPosition(e.matrixWorld),t.position.copy(pp),mp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(mp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Bh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Bh,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===vr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Bh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},il=new $,sl=new kn,gi=new $,Fo=class extends zt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new et,this.projectionMatrix=new et,this.projectionMatrixInverse=new et,this.coordinateSystem=qn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(il,sl,gi),gi.x===1&&gi.y===1&&gi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(il,sl,gi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(il,sl,gi),gi.x===1&&gi.y===1&&gi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(il,sl,gi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ms=new $,gp=new it,vp=new it,Kt=class extends Fo{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ds*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(fo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ds*2*Math.atan(Math.tan(fo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ms.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ms.x,ms.y).multiplyScalar(-e/ms.z),ms.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ms.x,ms.y).multiplyScalar(-e/ms.z)}getViewSize(e,t){return this.getViewBounds(e,gp,vp),t.subVectors(vp,gp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(fo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Yh=class extends Rr{constructor(){super(new Kt(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Ds*2*e.angle*this.focus,s=this.mapSize.width/this.mapSize.height*this.aspect,r=e.distance||t.far;(n!==t.fov||s!==t.aspect||r!==t.far)&&(t.fov=n,t.aspect=s,t.far=r,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},Uo=class extends Er{constructor(e,t,n=0,s=Math.PI/3,r=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(zt.DEFAULT_UP),this.updateMatrix(),this.target=new zt,this.distance=n,this.angle=s,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new Yh}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},Zh=class extends Rr{constructor(){super(new Kt(90,1,.5,500)),this.isPointLightShadow=!0}},Oo=class extends Er{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new Zh}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Gn=class extends Fo{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Kh=class extends Rr{constructor(){super(new Gn(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Bo=class extends Er{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(zt.DEFAULT_UP),this.updateMatrix(),this.target=new zt,this.shadow=new Kh}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Qi=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}};var kh=new WeakMap,ko=class extends Hn{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&ke("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&ke("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=vi.get(`image-bitmap:${e}`);if(o!==void 0){if(r.manager.itemStart(e),o.then){o.then(c=>{kh.has(o)===!0?(s&&s(kh.get(o)),r.manager.itemError(e),r.manager.itemEnd(e)):(t&&t(c),r.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let l=fetch(e,a).then(function(c){return c.blob()}).then(function(c){return createImageBitmap(c,Object.assign({},r.options,{colorSpaceConversion:"none"}))}).then(function(c){return vi.add(`image-bitmap:${e}`,c),t&&t(c),r.manager.itemEnd(e),c}).catch(function(c){s&&s(c),kh.set(l,c),vi.remove(`image-bitmap:${e}`),r.manager.itemError(e),r.manager.itemEnd(e)});vi.add(`image-bitmap:${e}`,l),r.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var fr=-90,dr=1,Cr=class extends zt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kt(fr,dr,e,t);s.layers=this.layers,this.add(s);let r=new Kt(fr,dr,e,t);r.layers=this.layers,this.add(r);let o=new Kt(fr,dr,e,t);o.layers=this.layers,this.add(o);let a=new Kt(fr,dr,e,t);a.layers=this.layers,this.add(a);let l=new Kt(fr,dr,e,t);l.layers=this.layers,this.add(l);let c=new Kt(fr,dr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===qn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===vr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,p),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Nl=class extends Kt{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Eu="\\[\\]\\.:\\/",kv=new RegExp("["+Eu+"]","g"),Ru="[^"+Eu+"]",zv="[^"+Eu.replace("\\.","")+"]",Hv=/((?:WC+[\/:])*)/.source.replace("WC",Ru),Gv=/(WCOD+)?/.source.replace("WCOD",zv),Vv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ru),Wv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ru),$v=new RegExp("^"+Hv+Gv+Vv+Wv+"$"),Xv=["material","materials","bones","map"],Jh=class{constructor(e,t,n){let s=n||It.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},It=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(kv,"")}static parseTrackName(e){let t=$v.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Xv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ke("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ke("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ke("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ke("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ke("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Ke("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ke("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ke("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ke("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};It.Composite=Jh;It.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};It.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};It.prototype.GetterByBindingType=[It.prototype._getValue_direct,It.prototype._getValue_array,It.prototype._getValue_arrayElement,It.prototype._getValue_toArray];It.prototype.SetterByBindingTypeAndVersioning=[[It.prototype._setValue_direct,It.prototype._setValue_direct_setNeedsUpdate,It.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[It.prototype._setValue_array,It.prototype._setValue_array_setNeedsUpdate,It.prototype._setValue_array_setMatrixWorldNeedsUpdate],[It.prototype._setValue_arrayElement,It.prototype._setValue_arrayElement_setNeedsUpdate,It.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[It.prototype._setValue_fromArray,It.prototype._setValue_fromArray_setNeedsUpdate,It.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var _1=new Float32Array(1);var jh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var _p=new $,rl,zh,zo=class extends zt{constructor(e=new $(0,0,1),t=new $(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",rl===void 0&&(rl=new Lt,rl.setAttribute("position",new kt([0,0,0,0,1,0],3)),zh=new Ml(.5,1,5,1),zh.translate(0,-.5,0)),this.position.copy(t),this.line=new yi(rl,new Xi({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new At(zh,new ii({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{_p.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(_p,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};function Cu(i,e,t,n){let s=qv(n);switch(t){case mu:return i*e;case ts:return i*e/s.components*s.byteLength;case zl:return i*e/s.components*s.byteLength;case Dn:return i*e*2/s.components*s.byteLength;case Hl:return i*e*2/s.components*s.byteLength;case gu:return i*e*3/s.components*s.byteLength;case yt:return i*e*4/s.components*s.byteLength;case Gl:return i*e*4/s.components*s.byteLength;case Wo:case $o:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Xo:case qo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wl:case Xl:return Math.max(i,16)*Math.max(e,8)/4;case Vl:case $l:return Math.max(i,8)*Math.max(e,8)/2;case ql:case Yl:case Kl:case Jl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Zl:case Yo:case jl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ql:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ec:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case tc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case nc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ic:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case sc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case rc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case oc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ac:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case lc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case cc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case hc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case uc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case fc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case dc:case pc:case mc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case gc:case vc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Zo:case _c:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function qv(i){switch(i){case Nn:case uu:return{byteLength:1,components:1};case Fr:case fu:case Jt:return{byteLength:2,components:1};case Bl:case kl:return{byteLength:2,components:4};case ri:case Ol:case _t:return{byteLength:4,components:1};case du:case pu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Em(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Zv(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<u.length;p++){let g=u[f],y=u[p];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++f,u[f]=y)}u.length=f+1;for(let p=0,g=u.length;p<g;p++){let y=u[p];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Kv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Jv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,jv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Qv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,e_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,t_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,n_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,i_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,s_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,r_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,o_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,a_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,l_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,c_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,h_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,u_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,f_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,d_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,p_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,m_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,g_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,v_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,__=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,y_=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,x_=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,b_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,M_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,S_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,w_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,A_="gl_FragColor = linearToOutputTexel( gl_FragColor );",T_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,E_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,R_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,C_=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,I_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,P_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,L_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,N_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,D_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,F_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,U_=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,O_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,B_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,k_=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,z_=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,H_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,G_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,V_=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,W_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,$_=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,X_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,q_=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Y_=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Z_=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,K_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,J_=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,j_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Q_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ey=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ty=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ny=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,iy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,sy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,ry=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,oy=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ay=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ly=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,cy=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,hy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uy=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,fy=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,dy=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,py=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,my=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,vy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,_y=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,yy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,xy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,by=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,My=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Sy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,wy=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Ay=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ty=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Ey=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ry=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Cy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Iy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Py=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Ly=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Ny=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Dy=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Fy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Uy=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Oy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,By=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,ky=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,zy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Hy=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Gy=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Vy=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Wy=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,$y=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Xy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Yy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Zy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ky=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Jy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jy=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Qy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ex=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,nx=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ix=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,sx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,rx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ox=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ax=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,lx=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,hx=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ux=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,fx=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,px=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mx=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,gx=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,vx=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,_x=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yx=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,xx=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bx=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mx=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Sx=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,wx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ax=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Tx=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ex=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Rx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,st={alphahash_fragment:Kv,alphahash_pars_fragment:Jv,alphamap_fragment:jv,alphamap_pars_fragment:Qv,alphatest_fragment:e_,alphatest_pars_fragment:t_,aomap_fragment:n_,aomap_pars_fragment:i_,batching_pars_vertex:s_,batching_vertex:r_,begin_vertex:o_,beginnormal_vertex:a_,bsdfs:l_,iridescence_fragment:c_,bumpmap_pars_fragment:h_,clipping_planes_fragment:u_,clipping_planes_pars_fragment:f_,clipping_planes_pars_vertex:d_,clipping_planes_vertex:p_,color_fragment:m_,color_pars_fragment:g_,color_pars_vertex:v_,color_vertex:__,common:y_,defaultnormal_vertex:x_,displacementmap_pars_vertex:b_,displacementmap_vertex:M_,emissivemap_fragment:S_,emissivemap_pars_fragment:w_,colorspace_fragment:A_,colorspace_pars_fragment:T_,envmap_fragment:E_,envmap_common_pars_fragment:R_,envmap_pars_fragment:C_,envmap_pars_vertex:I_,envmap_physical_pars_fragment:H_,envmap_vertex:P_,fog_vertex:L_,fog_pars_vertex:N_,fog_fragment:D_,fog_pars_fragment:F_,gradientmap_pars_fragment:U_,lightmap_pars_fragment:O_,lights_lambert_fragment:B_,lights_lambert_pars_fragment:k_,lights_pars_begin:z_,lights_toon_fragment:G_,lights_toon_pars_fragment:V_,lights_phong_fragment:W_,lights_phong_pars_fragment:$_,lights_physical_fragment:X_,lights_physical_pars_fragment:q_,lights_fragment_begin:Y_,lights_fragment_maps:Z_,lights_fragment_end:K_,lightprobes_pars_fragment:J_,logdepthbuf_fragment:j_,logdepthbuf_pars_fragment:Q_,logdepthbuf_pars_vertex:ey,logdepthbuf_vertex:ty,map_fragment:ny,map_pars_fragment:iy,map_particle_fragment:sy,map_particle_pars_fragment:ry,metalnessmap_fragment:oy,metalnessmap_pars_fragment:ay,morphinstance_vertex:ly,morphcolor_vertex:cy,morphnormal_vertex:hy,morphtarget_pars_vertex:uy,morphtarget_vertex:fy,normal_fragment_begin:dy,normal_fragment_maps:py,normal_pars_fragment:my,normal_pars_vertex:gy,normal_vertex:vy,normalmap_pars_fragment:_y,clearcoat_normal_fragment_begin:yy,clearcoat_normal_fragment_maps:xy,clearcoat_pars_fragment:by,iridescence_pars_fragment:My,opaque_fragment:Sy,packing:wy,premultiplied_alpha_fragment:Ay,project_vertex:Ty,dithering_fragment:Ey,dithering_pars_fragment:Ry,roughnessmap_fragment:Cy,roughnessmap_pars_fragment:Iy,shadowmap_pars_fragment:Py,shadowmap_pars_vertex:Ly,shadowmap_vertex:Ny,shadowmask_pars_fragment:Dy,skinbase_vertex:Fy,skinning_pars_vertex:Uy,skinning_vertex:Oy,skinnormal_vertex:By,specularmap_fragment:ky,specularmap_pars_fragment:zy,tonemapping_fragment:Hy,tonemapping_pars_fragment:Gy,transmission_fragment:Vy,transmission_pars_fragment:Wy,uv_pars_fragment:$y,uv_pars_vertex:Xy,uv_vertex:qy,worldpos_vertex:Yy,background_vert:Zy,background_frag:Ky,backgroundCube_vert:Jy,backgroundCube_frag:jy,cube_vert:Qy,cube_frag:ex,depth_vert:tx,depth_frag:nx,distance_vert:ix,distance_frag:sx,equirect_vert:rx,equirect_frag:ox,linedashed_vert:ax,linedashed_frag:lx,meshbasic_vert:cx,meshbasic_frag:hx,meshlambert_vert:ux,meshlambert_frag:fx,meshmatcap_vert:dx,meshmatcap_frag:px,meshnormal_vert:mx,meshnormal_frag:gx,meshphong_vert:vx,meshphong_frag:_x,meshphysical_vert:yx,meshphysical_frag:xx,meshtoon_vert:bx,meshtoon_frag:Mx,points_vert:Sx,points_frag:wx,shadow_vert:Ax,shadow_frag:Tx,sprite_vert:Ex,sprite_frag:Rx},Fe={common:{diffuse:{value:new Xe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Je},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Je}},envmap:{envMap:{value:null},envMapRotation:{value:new Je},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Je}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Je}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Je},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Je},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Je},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Je}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Je}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Je}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0},uvTransform:{value:new Je}},sprite:{diffuse:{value:new Xe(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Je},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0}}},wi={basic:{uniforms:gn([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.fog]),vertexShader:st.meshbasic_vert,fragmentShader:st.meshbasic_frag},lambert:{uniforms:gn([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new Xe(0)},envMapIntensity:{value:1}}]),vertexShader:st.meshlambert_vert,fragmentShader:st.meshlambert_frag},phong:{uniforms:gn([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new Xe(0)},specular:{value:new Xe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:st.meshphong_vert,fragmentShader:st.meshphong_frag},standard:{uniforms:gn([Fe.common,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.roughnessmap,Fe.metalnessmap,Fe.fog,Fe.lights,{emissive:{value:new Xe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag},toon:{uniforms:gn([Fe.common,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.gradientmap,Fe.fog,Fe.lights,{emissive:{value:new Xe(0)}}]),vertexShader:st.meshtoon_vert,fragmentShader:st.meshtoon_frag},matcap:{uniforms:gn([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,{matcap:{value:null}}]),vertexShader:st.meshmatcap_vert,fragmentShader:st.meshmatcap_frag},points:{uniforms:gn([Fe.points,Fe.fog]),vertexShader:st.points_vert,fragmentShader:st.points_frag},dashed:{uniforms:gn([Fe.common,Fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:st.linedashed_vert,fragmentShader:st.linedashed_frag},depth:{uniforms:gn([Fe.common,Fe.displacementmap]),vertexShader:st.depth_vert,fragmentShader:st.depth_frag},normal:{uniforms:gn([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,{opacity:{value:1}}]),vertexShader:st.meshnormal_vert,fragmentShader:st.meshnormal_frag},sprite:{uniforms:gn([Fe.sprite,Fe.fog]),vertexShader:st.sprite_vert,fragmentShader:st.sprite_frag},background:{uniforms:{uvTransform:{value:new Je},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:st.background_vert,fragmentShader:st.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Je}},vertexShader:st.backgroundCube_vert,fragmentShader:st.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:st.cube_vert,fragmentShader:st.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:st.equirect_vert,fragmentShader:st.equirect_frag},distance:{uniforms:gn([Fe.common,Fe.displacementmap,{referencePosition:{value:new $},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:st.distance_vert,fragmentShader:st.distance_frag},shadow:{uniforms:gn([Fe.lights,Fe.fog,{color:{value:new Xe(0)},opacity:{value:1}}]),vertexShader:st.shadow_vert,fragmentShader:st.shadow_frag}};wi.physical={uniforms:gn([wi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Je},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Je},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Je},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Je},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Je},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Je},sheen:{value:0},sheenColor:{value:new Xe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Je},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Je},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Je},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Je},attenuationDistance:{value:0},attenuationColor:{value:new Xe(0)},specularColor:{value:new Xe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Je},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Je},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Je}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag};var Mc={r:0,b:0,g:0},Cx=new et,Rm=new Je;Rm.set(-1,0,0,0,1,0,0,0,1);function Ix(i,e,t,n,s,r){let o=new Xe(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function p(A){let S=A.isScene===!0?A.background:null;if(S&&S.isTexture){let w=A.backgroundBlurriness>0;S=e.get(S,w)}return S}function g(A){let S=!1,w=p(A);w===null?m(o,a):w&&w.isColor&&(m(w,1),S=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(A,S){let w=p(S);w&&w.isCubeTexture?(c===void 0&&(c=new At(new Tr(1,1,1),new Ht({name:"BackgroundCubeMaterial",uniforms:Xs(wi.backgroundCube.uniforms),vertexShader:wi.backgroundCube.vertexShader,fragmentShader:wi.backgroundCube.fragmentShader,side:hn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Cx.makeRotationFromEuler(S.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Rm),c.material.toneMapped=rt.getTransfer(w.colorSpace)!==bt,(h!==w||u!==w.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,u=w.version,f=i.toneMapping),c.layers.enableAll(),A.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new At(new si(2,2),new Ht({name:"BackgroundMaterial",uniforms:Xs(wi.background.uniforms),vertexShader:wi.background.vertexShader,fragmentShader:wi.background.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=rt.getTransfer(w.colorSpace)!==bt,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||u!==w.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,u=w.version,f=i.toneMapping),l.layers.enableAll(),A.unshift(l,l.geometry,l.material,0,0,null))}function m(A,S){A.getRGB(Mc,Tu(i)),t.buffers.color.setClear(Mc.r,Mc.g,Mc.b,S,r)}function v(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(A,S=1){o.set(A),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(A){a=A,m(o,a)},render:g,addToRenderList:y,dispose:v}}function Px(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(F,B,z,D,W){let q=!1,K=u(F,D,z,B);r!==K&&(r=K,c(r.object)),q=p(F,D,z,W),q&&g(F,D,z,W),W!==null&&e.update(W,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,w(F,B,z,D),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return i.createVertexArray()}function c(F){return i.bindVertexArray(F)}function h(F){return i.deleteVertexArray(F)}function u(F,B,z,D){let W=D.wireframe===!0,q=n[B.id];q===void 0&&(q={},n[B.id]=q);let K=F.isInstancedMesh===!0?F.id:0,fe=q[K];fe===void 0&&(fe={},q[K]=fe);let J=fe[z.id];J===void 0&&(J={},fe[z.id]=J);let ae=J[W];return ae===void 0&&(ae=f(l()),J[W]=ae),ae}function f(F){let B=[],z=[],D=[];for(let W=0;W<t;W++)B[W]=0,z[W]=0,D[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:z,attributeDivisors:D,object:F,attributes:{},index:null}}function p(F,B,z,D){let W=r.attributes,q=B.attributes,K=0,fe=z.getAttributes();for(let J in fe)if(fe[J].location>=0){let ce=W[J],we=q[J];if(we===void 0&&(J==="instanceMatrix"&&F.instanceMatrix&&(we=F.instanceMatrix),J==="instanceColor"&&F.instanceColor&&(we=F.instanceColor)),ce===void 0||ce.attribute!==we||we&&ce.data!==we.data)return!0;K++}return r.attributesNum!==K||r.index!==D}function g(F,B,z,D){let W={},q=B.attributes,K=0,fe=z.getAttributes();for(let J in fe)if(fe[J].location>=0){let ce=q[J];ce===void 0&&(J==="instanceMatrix"&&F.instanceMatrix&&(ce=F.instanceMatrix),J==="instanceColor"&&F.instanceColor&&(ce=F.instanceColor));let we={};we.attribute=ce,ce&&ce.data&&(we.data=ce.data),W[J]=we,K++}r.attributes=W,r.attributesNum=K,r.index=D}function y(){let F=r.newAttributes;for(let B=0,z=F.length;B<z;B++)F[B]=0}function m(F){v(F,0)}function v(F,B){let z=r.newAttributes,D=r.enabledAttributes,W=r.attributeDivisors;z[F]=1,D[F]===0&&(i.enableVertexAttribArray(F),D[F]=1),W[F]!==B&&(i.vertexAttribDivisor(F,B),W[F]=B)}function A(){let F=r.newAttributes,B=r.enabledAttributes;for(let z=0,D=B.length;z<D;z++)B[z]!==F[z]&&(i.disableVertexAttribArray(z),B[z]=0)}function S(F,B,z,D,W,q,K){K===!0?i.vertexAttribIPointer(F,B,z,W,q):i.vertexAttribPointer(F,B,z,D,W,q)}function w(F,B,z,D){y();let W=D.attributes,q=z.getAttributes(),K=B.defaultAttributeValues;for(let fe in q){let J=q[fe];if(J.location>=0){let ae=W[fe];if(ae===void 0&&(fe==="instanceMatrix"&&F.instanceMatrix&&(ae=F.instanceMatrix),fe==="instanceColor"&&F.instanceColor&&(ae=F.instanceColor)),ae!==void 0){let ce=ae.normalized,we=ae.itemSize,De=e.get(ae);if(De===void 0)continue;let ie=De.buffer,Re=De.type,Ue=De.bytesPerElement,ze=Re===i.INT||Re===i.UNSIGNED_INT||ae.gpuType===Ol;if(ae.isInterleavedBufferAttribute){let me=ae.data,$e=me.isInterleavedBuffer===!0?me.stride:me.itemSize,Mt=ae.offset;if(me.isInstancedInterleavedBuffer||me.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)v(J.location+Ve,me.meshPerAttribute);F.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=me.meshPerAttribute*me.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve);i.bindBuffer(i.ARRAY_BUFFER,ie);for(let Ve=0;Ve<J.locationSize;Ve++)S(J.location+Ve,we/J.locationSize,Re,ce,$e*Ue,(Mt+we/J.locationSize*Ve)*Ue,ze)}else{if(ae.isInstancedBufferAttribute){for(let me=0;me<J.locationSize;me++)v(J.location+me,ae.meshPerAttribute);F.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let me=0;me<J.locationSize;me++)m(J.location+me);i.bindBuffer(i.ARRAY_BUFFER,ie);for(let me=0;me<J.locationSize;me++)S(J.location+me,we/J.locationSize,Re,ce,we*Ue,we/J.locationSize*me*Ue,ze)}}else if(K!==void 0){let ce=K[fe];if(ce!==void 0)switch(ce.length){case 2:i.vertexAttrib2fv(J.location,ce);break;case 3:i.vertexAttrib3fv(J.location,ce);break;case 4:i.vertexAttrib4fv(J.location,ce);break;default:i.vertexAttrib1fv(J.location,ce)}}}}A()}function T(){L();for(let F in n){let B=n[F];for(let z in B){let D=B[z];for(let W in D){let q=D[W];for(let K in q)h(q[K].object),delete q[K];delete D[W]}}delete n[F]}}function E(F){if(n[F.id]===void 0)return;let B=n[F.id];for(let z in B){let D=B[z];for(let W in D){let q=D[W];for(let K in q)h(q[K].object),delete q[K];delete D[W]}}delete n[F.id]}function x(F){for(let B in n){let z=n[B];for(let D in z){let W=z[D];if(W[F.id]===void 0)continue;let q=W[F.id];for(let K in q)h(q[K].object),delete q[K];delete W[F.id]}}}function b(F){for(let B in n){let z=n[B],D=F.isInstancedMesh===!0?F.id:0,W=z[D];if(W!==void 0){for(let q in W){let K=W[q];for(let fe in K)h(K[fe].object),delete K[fe];delete W[q]}delete z[D],Object.keys(z).length===0&&delete n[B]}}}function L(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:I,dispose:T,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:m,disableUnusedAttributes:A}}function Lx(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let p=0;p<h;p++)f+=c[p];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Nx(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==yt&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let b=x===Jt&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==Nn&&x!==_t&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),v=i.getParameter(i.MAX_VERTEX_ATTRIBS),A=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),T=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:p,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:v,maxVertexUniforms:A,maxVaryings:S,maxFragmentUniforms:w,maxSamples:T,samples:E}}function Dx(i){let e=this,t=null,n=0,s=!1,r=!1,o=new ni,a=new Je,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let p=u.length!==0||f||n!==0||s;return s=f,n=u.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,p){let g=u.clippingPlanes,y=u.clipIntersection,m=u.clipShadows,v=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let A=r?0:n,S=A*4,w=v.clippingState||null;l.value=w,w=h(g,f,S,p);for(let T=0;T!==S;++T)w[T]=t[T];v.clippingState=w,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=A}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,f,p,g){let y=u!==null?u.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let v=p+y*4,A=f.matrixWorldInverse;a.getNormalMatrix(A),(m===null||m.length<v)&&(m=new Float32Array(v));for(let S=0,w=p;S!==y;++S,w+=4)o.copy(u[S]).applyMatrix4(A,a),o.normal.toArray(m,w),m[w+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}}var Qo=class extends cn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ro(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Tr(5,5,5),r=new Ht({name:"CubemapFromEquirect",uniforms:Xs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:hn,blending:Hs});r.uniforms.tEquirect.value=t;let o=new At(s,r),a=t.minFilter;return t.minFilter===Vn&&(t.minFilter=Et),new Cr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},om=256,Fx=3,Ux=20,Cm=256,Im=16,Ox=3,Bx=new $,kx=new Xe,wc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Cr(1,10,null),this._boxMesh=new At(new Tr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=Bx}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(kx));let m=new Cr(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=cm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=lm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(om,Su(e))}_fromTexture(e,t){e.mapping===Vs||e.mapping===Nr?this._setSize(e.image.length===0?om:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=am(e,!1,!1),n=Math.log2(e)-Fx;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=am(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Vs||e.mapping===Nr?(this._cubemapMaterial===null&&(this._cubemapMaterial=cm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=lm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=zx(),this._integrationMaterial=Hx());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Im);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Ox)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Cm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Gx());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function am(i,e,t){return new Qo(i,{minFilter:Vn,generateMipmaps:e,type:Jt,colorSpace:Ot,depthBuffer:t})}function ea(i,e,t){return new Ht({name:i,uniforms:e,vertexShader:st.cube_vert,fragmentShader:t,side:hn,blending:Hs,depthTest:!1,depthWrite:!1})}function zx(){return ea("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Cm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Hx(){return ea("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Im}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Gx(){return ea("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ux}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function lm(){return ea("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function cm(){return ea("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Vx(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,p=!1){return f==null?null:p?o(f):r(f)}function r(f){if(f&&f.isTexture){let p=f.mapping;if(p===Dl||p===Fl)if(e.has(f)){let g=e.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let y=new Qo(g.height);return y.fromEquirectangularTexture(i,f),e.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,g=p===Dl||p===Fl,y=p===Vs||p===Nr;if(g||y){let m=t.get(f),v=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==v)return n===null&&(n=new wc(i)),m=g?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),m.texture;if(m!==void 0)return m.texture;{let A=f.image;return g&&A&&A.height>0||y&&A&&l(A)?(n===null&&(n=new wc(i)),m=g?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,p){return p===Dl?f.mapping=Vs:p===Fl&&(f.mapping=Nr),f}function l(f){let p=0,g=6;for(let y=0;y<g;y++)f[y]!==void 0&&p++;return p===g}function c(f){let p=f.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function h(f){let p=f.target;p.removeEventListener("dispose",h);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function Wx(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ps("WebGLRenderer: "+n+" extension not supported."),s}}}function $x(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let m in y)e.update(y[m],i.ARRAY_BUFFER)}function u(g){let y=g.index,m=g.attributes.position,v=0;if(m===void 0)return;let A=y!==null?y.array.length:m.array.length/3-1,S=m.count>=65535?Us:Fs,w=new S(Math.ceil(A/3)*6,1),T=w.array;if(y!==null){let x=y.array;v=y.version;for(let b=0,L=0;b<A;b+=3){let I=x[b+0],F=x[b+1],B=x[b+2];T[L++]=I,T[L++]=F,T[L++]=F,T[L++]=B,T[L++]=B,T[L++]=I}}else{v=m.version;for(let x=0,b=0;x<A;x+=3){let L=x+0,I=x+1,F=x+2;T[b++]=L,T[b++]=I,T[b++]=I,T[b++]=F,T[b++]=F,T[b++]=L}}w.version=v;let E=r.get(g);E&&e.remove(E),r.set(g,w)}function f(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&u(g)}else u(g);return r.get(g)}function p(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:f,dispose:p}}function Xx(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*o),t.update(f,n,1)}function c(u,f,p){p!==0&&(i.drawElementsInstanced(n,f,r,u*o,p),t.update(f,n,p))}function h(u,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,p);let y=0;for(let m=0;m<p;m++)y+=f[m];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function qx(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Ke("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Yx(i,e,t){let n=new WeakMap,s=new wt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let L=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",L)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],v=a.morphAttributes.normal||[],A=a.morphAttributes.color||[],S=0;p===!0&&(S=1),g===!0&&(S=2),y===!0&&(S=3);let w=a.attributes.position.count*S,T=1;w>e.maxTextureSize&&(T=Math.ceil(w/e.maxTextureSize),w=e.maxTextureSize);let E=new Float32Array(w*T*4*u),x=new vo(E,w,T,u);x.type=_t,x.needsUpdate=!0;let b=S*4;for(let I=0;I<u;I++){let F=m[I],B=v[I],z=A[I],D=w*T*4*I;for(let W=0;W<F.count;W++){let q=W*b;p===!0&&(s.fromBufferAttribute(F,W),E[D+q+0]=s.x,E[D+q+1]=s.y,E[D+q+2]=s.z,E[D+q+3]=0),g===!0&&(s.fromBufferAttribute(B,W),E[D+q+4]=s.x,E[D+q+5]=s.y,E[D+q+6]=s.z,E[D+q+7]=0),y===!0&&(s.fromBufferAttribute(z,W),E[D+q+8]=s.x,E[D+q+9]=s.y,E[D+q+10]=s.z,E[D+q+11]=z.itemSize===4?s.w:1)}}f={count:u,texture:x,size:new it(w,T)},n.set(a,f),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let y=0;y<c.length;y++)p+=c[y];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function Zx(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=e.get(c,u);if(r.get(f)!==h&&(e.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var Kx={[Go]:"LINEAR_TONE_MAPPING",[ou]:"REINHARD_TONE_MAPPING",[au]:"CINEON_TONE_MAPPING",[lu]:"ACES_FILMIC_TONE_MAPPING",[Vo]:"AGX_TONE_MAPPING",[Lr]:"NEUTRAL_TONE_MAPPING",[cu]:"CUSTOM_TONE_MAPPING"};function Jx(i,e,t,n,s,r){let o=new cn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Lt;h.setAttribute("position",new kt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new kt([0,2,0,0,2,0],2));let u=new Sl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new At(h,u),p=new Gn(-1,1,1,-1,0,1),g=null,y=null,m=!1,v,A=null,S=[],w=!1;this.setSize=function(T,E){o.setSize(T,E),a!==null&&a.setSize(T,E),l!==null&&l.setSize(T,E);for(let x=0;x<S.length;x++){let b=S[x];b.setSize&&b.setSize(T,E)}},this.setEffects=function(T){S=T,w=S.length>0&&S[0].isRenderPass===!0;let E=o.width,x=o.height;S.length>0&&a===null&&(a=new cn(E,x,{type:Jt,depthBuffer:!1,stencilBuffer:!1}),l=new cn(E,x,{type:Jt,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&S.some(L=>L.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new qi(E,x),r===!0&&(c.format=es,c.type=$s)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let L=0;L<S.length;L++){let I=S[L];I.setSize&&I.setSize(E,x),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(T,E){if(m||T.toneMapping===bi&&S.length===0)return!1;if(A=E,E!==null){let x=E.width,b=E.height;(o.width!==x||o.height!==b)&&this.setSize(x,b)}return w===!1&&T.setRenderTarget(o),v=T.toneMapping,T.toneMapping=bi,!0},this.hasRenderPass=function(){return w},this.end=function(T,E){T.toneMapping=v,m=!0;let x=o,b=a;for(let L=0;L<S.length;L++){let I=S[L];I.enabled!==!1&&(I.render(T,b,x,E),I.needsSwap!==!1&&(x=b,b=b===a?l:a))}if(g!==T.outputColorSpace||y!==T.toneMapping){g=T.outputColorSpace,y=T.toneMapping,u.defines={},rt.getTransfer(g)===bt&&(u.defines.SRGB_TRANSFER="");let L=Kx[y];L&&(u.defines[L]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,T.setRenderTarget(A),T.render(f,p),A=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Pm=new an,Lm=new qi(1,1),Nm=new Co(1),Dm=new vo,Fm=new vl,Um=new Ro,hm=[],um=[],fm=new Float32Array(16),dm=new Float32Array(9),pm=new Float32Array(4);function Br(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=hm[s];if(r===void 0&&(r=new Float32Array(s),hm[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function tn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function nn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Tc(i,e){let t=um[e];t===void 0&&(t=new Int32Array(e),um[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function jx(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Qx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(tn(t,e))return;i.uniform2fv(this.addr,e),nn(t,e)}}function eb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(tn(t,e))return;i.uniform3fv(this.addr,e),nn(t,e)}}function tb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(tn(t,e))return;i.uniform4fv(this.addr,e),nn(t,e)}}function nb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(tn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),nn(t,e)}else{if(tn(t,n))return;pm.set(n),i.uniformMatrix2fv(this.addr,!1,pm),nn(t,n)}}function ib(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(tn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),nn(t,e)}else{if(tn(t,n))return;dm.set(n),i.uniformMatrix3fv(this.addr,!1,dm),nn(t,n)}}function sb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(tn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),nn(t,e)}else{if(tn(t,n))return;fm.set(n),i.uniformMatrix4fv(this.addr,!1,fm),nn(t,n)}}function rb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function ob(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(tn(t,e))return;i.uniform2iv(this.addr,e),nn(t,e)}}function ab(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(tn(t,e))return;i.uniform3iv(this.addr,e),nn(t,e)}}function lb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(tn(t,e))return;i.uniform4iv(this.addr,e),nn(t,e)}}function cb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function hb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(tn(t,e))return;i.uniform2uiv(this.addr,e),nn(t,e)}}function ub(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(tn(t,e))return;i.uniform3uiv(this.addr,e),nn(t,e)}}function fb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(tn(t,e))return;i.uniform4uiv(this.addr,e),nn(t,e)}}function Ec(i){return i.version===0&&(i.compareFunction=xu,i.needsUpdate=!0),i}function db(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ec(Lm):r=Pm,t.setTexture2D(e||r,s)}function pb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Fm,s)}function mb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ec(Nm):r=Um,t.setTextureCube(e||r,s)}function gb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Dm,s)}function vb(i){switch(i){case 5126:return jx;case 35664:return Qx;case 35665:return eb;case 35666:return tb;case 35674:return nb;case 35675:return ib;case 35676:return sb;case 5124:case 35670:return rb;case 35667:case 35671:return ob;case 35668:case 35672:return ab;case 35669:case 35673:return lb;case 5125:return cb;case 36294:return hb;case 36295:return ub;case 36296:return fb;case 35678:case 36198:case 36298:case 36306:case 35682:return db;case 35679:case 36299:case 36307:return pb;case 35680:case 36300:case 36308:case 36293:return mb;case 36289:case 36303:case 36311:case 36292:return gb}}function _b(i,e){i.uniform1fv(this.addr,e)}function yb(i,e){let t=Br(e,this.size,2);i.uniform2fv(this.addr,t)}function xb(i,e){let t=Br(e,this.size,3);i.uniform3fv(this.addr,t)}function bb(i,e){let t=Br(e,this.size,4);i.uniform4fv(this.addr,t)}function Mb(i,e){let t=Br(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Sb(i,e){let t=Br(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function wb(i,e){let t=Br(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Ab(i,e){i.uniform1iv(this.addr,e)}function Tb(i,e){i.uniform2iv(this.addr,e)}function Eb(i,e){i.uniform3iv(this.addr,e)}function Rb(i,e){i.uniform4iv(this.addr,e)}function Cb(i,e){i.uniform1uiv(this.addr,e)}function Ib(i,e){i.uniform2uiv(this.addr,e)}function Pb(i,e){i.uniform3uiv(this.addr,e)}function Lb(i,e){i.uniform4uiv(this.addr,e)}function Nb(i,e,t){let n=this.cache,s=e.length,r=Tc(t,s);tn(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Ec(Lm):o=Pm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Db(i,e,t){let n=this.cache,s=e.length,r=Tc(t,s);tn(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Fm,r[o])}function Fb(i,e,t){let n=this.cache,s=e.length,r=Tc(t,s);tn(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Ec(Nm):o=Um;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Ub(i,e,t){let n=this.cache,s=e.length,r=Tc(t,s);tn(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Dm,r[o])}function Ob(i){switch(i){case 5126:return _b;case 35664:return yb;case 35665:return xb;case 35666:return bb;case 35674:return Mb;case 35675:return Sb;case 35676:return wb;case 5124:case 35670:return Ab;case 35667:case 35671:return Tb;case 35668:case 35672:return Eb;case 35669:case 35673:return Rb;case 5125:return Cb;case 36294:return Ib;case 36295:return Pb;case 36296:return Lb;case 35678:case 36198:case 36298:case 36306:case 35682:return Nb;case 35679:case 36299:case 36307:return Db;case 35680:case 36300:case 36308:case 36293:return Fb;case 36289:case 36303:case 36311:case 36292:return Ub}}var Lu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=vb(t.type)}},Nu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ob(t.type)}},Du=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Iu=/(\w+)(\])?(\[|\.)?/g;function mm(i,e){i.seq.push(e),i.map[e.id]=e}function Bb(i,e,t){let n=i.name,s=n.length;for(Iu.lastIndex=0;;){let r=Iu.exec(n),o=Iu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){mm(t,c===void 0?new Lu(a,i,e):new Nu(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Du(a),mm(t,u)),t=u}}}var Or=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Bb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function gm(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var kb=37297,zb=0;function Hb(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var vm=new Je;function Gb(i){rt._getMatrix(vm,rt.workingColorSpace,i);let e=`mat3( ${vm.elements.map(t=>t.toFixed(4))} )`;switch(rt.getTransfer(i)){case mo:return[e,"LinearTransferOETF"];case bt:return[e,"sRGBTransferOETF"];default:return ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function _m(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Hb(i.getShaderSource(e),a)}else return r}function Vb(i,e){let t=Gb(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Wb={[Go]:"Linear",[ou]:"Reinhard",[au]:"Cineon",[lu]:"ACESFilmic",[Vo]:"AgX",[Lr]:"Neutral",[cu]:"Custom"};function $b(i,e){let t=Wb[e];return t===void 0?(ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Sc=new $;function Xb(){rt.getLuminanceCoefficients(Sc);let i=Sc.x.toFixed(4),e=Sc.y.toFixed(4),t=Sc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function qb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(jo).join(`
`)}function Yb(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Zb(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function jo(i){return i!==""}function ym(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function xm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Kb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Fu(i){return i.replace(Kb,Jb)}function Jb(i,e){let t=st[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Fu(t)}var jb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function bm(i){return i.replace(jb,Qb)}function Qb(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Mm(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var eM={[Ho]:"SHADOWMAP_TYPE_PCF",[Ir]:"SHADOWMAP_TYPE_VSM"};function tM(i){return eM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var nM={[Nr]:"ENVMAP_MODE_REFRACTION"};function iM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":nM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var sM={[ru]:"ENVMAP_BLENDING_MULTIPLY",[zp]:"ENVMAP_BLENDING_MIX",[Hp]:"ENVMAP_BLENDING_ADD"};function rM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":sM[i.combine]||"ENVMAP_BLENDING_NONE"}function oM(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=tM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=iM(t),u=rM(t),f=qb(t),p=Yb(r),g=s.createProgram(),y,m,v=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(jo).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(jo).join(`
`),m.length>0&&(m+=`
`)):(y=[Mm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(jo).join(`
`),m=[Mm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==bi?"#define TONE_MAPPING":"",t.toneMapping!==bi?st.tonemapping_pars_fragment:"",t.toneMapping!==bi?$b("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",st.colorspace_pars_fragment,Vb("linearToOutputTexel",t.outputColorSpace),Xb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(jo).join(`
`)),o=Fu(o),o=ym(o,t),o=xm(o,t),a=Fu(a),a=ym(a,t),a=xm(a,t),o=bm(o),a=bm(a),t.isRawShaderMaterial!==!0&&(v=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",t.glslVersion===wn?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===wn?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let A=v+y+o,S=v+m+a,w=gm(s,s.VERTEX_SHADER,A),T=gm(s,s.FRAGMENT_SHADER,S);s.attachShader(g,w),s.attachShader(g,T),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(I){if(i.debug.checkShaderErrors){let F=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(w)||"",z=s.getShaderInfoLog(T)||"",D=F.trim(),W=B.trim(),q=z.trim(),K=!0,fe=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(K=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,T);else{let J=_m(s,w,"vertex"),ae=_m(s,T,"fragment");Ke("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+D+`
`+J+`
`+ae)}else D!==""?ke("WebGLProgram: Program Info Log:",D):(W===""||q==="")&&(fe=!1);fe&&(I.diagnostics={runnable:K,programLog:D,vertexShader:{log:W,prefix:y},fragmentShader:{log:q,prefix:m}})}s.deleteShader(w),s.deleteShader(T),x=new Or(s,g),b=Zb(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let L=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,kb)),L},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=zb++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=T,this}var aM=0,Uu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Ou(e),t.set(e,n)),n}},Ou=class{constructor(e){this.id=aM++,this.code=e,this.usedTimes=0}};function lM(i){return i===Dn||i===Yo||i===Zo}function cM(i,e,t,n,s,r){let o=new _o,a=new Uu,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,b,L,I,F,B){let z=I.fog,D=F.geometry,W=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,K=e.get(x.envMap||W,q),fe=f[x.type],J=n.precision;x.precision!==null&&(J=n.getMaxPrecision(x.precision),J!==x.precision&&ke("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let ae=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ce=ae!==void 0?ae.length:0,we=0;D.morphAttributes.position!==void 0&&(we=1),D.morphAttributes.normal!==void 0&&(we=2),D.morphAttributes.color!==void 0&&(we=3);let De,ie,Re,Ue;if(fe){let Le=wi[fe];De=Le.vertexShader,ie=Le.fragmentShader}else{De=x.vertexShader,ie=x.fragmentShader;let Le=a.getVertexShaderStage(x),vt=a.getFragmentShaderStage(x);a.update(x,Le,vt),Re=Le.id,Ue=vt.id}let ze=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),$e=F.isInstancedMesh===!0,Mt=F.isBatchedMesh===!0,Ve=!!x.map,ft=!!x.matcap,mt=!!K,at=mt&&K.isPMREMTexture===!0,Vt=!!x.aoMap,Bt=!!x.lightMap,sn=!!x.bumpMap&&x.wireframe===!1,Dt=!!x.normalMap,Wn=!!x.displacementMap,qt=!!x.emissiveMap,vn=!!x.metalnessMap,_n=!!x.roughnessMap,An=x.anisotropy>0,V=x.clearcoat>0,yn=x.diffuseRoughness>0,Rt=x.dispersion>0,Ct=x.retroreflectivity>0,Ce=x.iridescence>0,Yt=x.sheen>0,Ge=x.transmission>0,je=An&&!!x.anisotropyMap,O=V&&!!x.clearcoatMap,R=V&&!!x.clearcoatNormalMap,Z=V&&!!x.clearcoatRoughnessMap,ge=yn&&!!x.diffuseRoughnessMap,le=Ce&&!!x.iridescenceMap,be=Ce&&!!x.iridescenceThicknessMap,Ie=Yt&&!!x.sheenColorMap,te=Yt&&!!x.sheenRoughnessMap,se=!!x.specularMap,Me=!!x.specularColorMap,k=!!x.specularIntensityMap,ne=Ge&&!!x.transmissionMap,j=Ge&&!!x.thicknessMap,Ae=!!x.gradientMap,ve=!!x.alphaMap,Se=x.alphaTest>0,Be=!!x.alphaHash,tt=!!x.extensions,_e=bi;x.toneMapped&&(ze===null||ze.isXRRenderTarget===!0)&&(_e=i.toneMapping);let He=at?K.isCompressedCubeTexture?K.image[0].mipmaps:K.mipmaps:null,Qe={shaderID:fe,shaderType:x.type,shaderName:x.name,vertexShader:De,fragmentShader:ie,defines:x.defines,customVertexShaderID:Re,customFragmentShaderID:Ue,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:Mt,batchingColor:Mt&&F._colorsTexture!==null,instancing:$e,instancingColor:$e&&F.instanceColor!==null,instancingMorph:$e&&F.morphTexture!==null,outputColorSpace:ze===null?i.outputColorSpace:ze.isXRRenderTarget===!0?ze.texture.colorSpace:rt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ve,matcap:ft,envMap:mt,envMapMode:mt&&K.mapping,envMapPMREM:at,envMapMaxLod:at?He.length-1:null,envMapSize:at?He[0].width:null,aoMap:Vt,lightMap:Bt,bumpMap:sn,normalMap:Dt,displacementMap:Wn,emissiveMap:qt,normalMapObjectSpace:Dt&&x.normalMapType===$p,normalMapTangentSpace:Dt&&x.normalMapType===yc,packedNormalMap:Dt&&x.normalMapType===yc&&lM(x.normalMap.format),metalnessMap:vn,roughnessMap:_n,anisotropy:An,anisotropyMap:je,clearcoat:V,clearcoatMap:O,clearcoatNormalMap:R,clearcoatRoughnessMap:Z,diffuseRoughness:yn,diffuseRoughnessMap:ge,dispersion:Rt,retroreflection:Ct,iridescence:Ce,iridescenceMap:le,iridescenceThicknessMap:be,sheen:Yt,sheenColorMap:Ie,sheenRoughnessMap:te,specularMap:se,specularColorMap:Me,specularIntensityMap:k,transmission:Ge,transmissionMap:ne,thicknessMap:j,gradientMap:Ae,opaque:x.transparent===!1&&x.blending===Pr&&x.alphaToCoverage===!1,alphaMap:ve,alphaTest:Se,alphaHash:Be,combine:x.combine,mapUv:Ve&&p(x.map.channel),aoMapUv:Vt&&p(x.aoMap.channel),lightMapUv:Bt&&p(x.lightMap.channel),bumpMapUv:sn&&p(x.bumpMap.channel),normalMapUv:Dt&&p(x.normalMap.channel),displacementMapUv:Wn&&p(x.displacementMap.channel),emissiveMapUv:qt&&p(x.emissiveMap.channel),metalnessMapUv:vn&&p(x.metalnessMap.channel),roughnessMapUv:_n&&p(x.roughnessMap.channel),anisotropyMapUv:je&&p(x.anisotropyMap.channel),clearcoatMapUv:O&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:R&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ge&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:le&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:be&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:Ie&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(x.sheenRoughnessMap.channel),specularMapUv:se&&p(x.specularMap.channel),specularColorMapUv:Me&&p(x.specularColorMap.channel),specularIntensityMapUv:k&&p(x.specularIntensityMap.channel),transmissionMapUv:ne&&p(x.transmissionMap.channel),thicknessMapUv:j&&p(x.thicknessMap.channel),alphaMapUv:ve&&p(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Dt||An),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:F.isPoints===!0&&!!D.attributes.uv&&(Ve||ve),fog:!!z,useFog:x.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&Dt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:me,skinning:F.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ce,morphTextureStride:we,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(Le=>Le.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&L.length>0,shadowMapType:i.shadowMap.type,toneMapping:_e,decodeVideoTexture:Ve&&x.map.isVideoTexture===!0&&rt.getTransfer(x.map.colorSpace)===bt,decodeVideoTextureEmissive:qt&&x.emissiveMap.isVideoTexture===!0&&rt.getTransfer(x.emissiveMap.colorSpace)===bt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ln,flipSided:x.side===hn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:tt&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&x.extensions.multiDraw===!0||Mt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let L in x.defines)b.push(L),b.push(x.defines[L]);return x.isRawShaderMaterial===!1&&(m(b,x),v(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function m(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function v(x,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function A(x){let b=f[x.type],L;if(b){let I=wi[b];L=im.clone(I.uniforms)}else L=x.uniforms;return L}function S(x,b){let L=h.get(b);return L!==void 0?++L.usedTimes:(L=new oM(i,b,x,s),c.push(L),h.set(b,L)),L}function w(x){if(--x.usedTimes===0){let b=c.indexOf(x);c[b]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function T(x){a.remove(x)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:A,acquireProgram:S,releaseProgram:w,releaseShaderCache:T,programs:c,dispose:E}}function hM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function uM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Sm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function wm(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,g,y,m,v){let A=i[e];return A===void 0?(A={id:f.id,object:f,geometry:p,material:g,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:m,group:v},i[e]=A):(A.id=f.id,A.object=f,A.geometry=p,A.material=g,A.materialVariant=o(f),A.groupOrder=y,A.renderOrder=f.renderOrder,A.z=m,A.group=v),e++,A}function l(f,p,g,y,m,v,A){A.reversedDepth===!0&&(m=-m);let S=a(f,p,g,y,m,v);g.transmission>0?n.push(S):g.transparent===!0?s.push(S):t.push(S)}function c(f,p,g,y,m,v){let A=a(f,p,g,y,m,v);g.transmission>0?n.unshift(A):g.transparent===!0?s.unshift(A):t.unshift(A)}function h(f,p){t.length>1&&t.sort(f||uM),n.length>1&&n.sort(p||Sm),s.length>1&&s.sort(p||Sm)}function u(){for(let f=e,p=i.length;f<p;f++){let g=i[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function fM(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new wm,i.set(n,[o])):s>=r.length?(o=new wm,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function dM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new $,color:new Xe};break;case"SpotLight":t={position:new $,direction:new $,color:new Xe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new $,color:new Xe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new $,skyColor:new Xe,groundColor:new Xe};break;case"RectAreaLight":t={color:new Xe,position:new $,halfWidth:new $,halfHeight:new $};break}return i[e.id]=t,t}}}function pM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var mM=0;function gM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function vM(i){let e=new dM,t=pM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new $);let s=new $,r=new et,o=new et;function a(c){let h=0,u=0,f=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let p=0,g=0,y=0,m=0,v=0,A=0,S=0,w=0,T=0,E=0,x=0,b=0,L=0,I=0;c.sort(gM);for(let B=0,z=c.length;B<z;B++){let D=c[B],W=D.color,q=D.intensity,K=D.distance,fe=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Dn?fe=D.shadow.map.texture:fe=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=W.r*q,u+=W.g*q,f+=W.b*q;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],q);I++}else if(D.isSunLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let ae=D.shadow,ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize.copy(ae.mapSize).multiply(ae.getFrameExtents()),n.sunShadow[g]=ce,n.sunShadowMap[g]=fe;let we=ae.getViewportCount();for(let De=0;De<we;De++)n.sunShadowMatrix[y+De]=ae.getMatrix(De),n.sunShadowCascade[y+De]=ae._cascadeData[De];y+=we,g++}n.sun[p]=J,p++}else if(D.isDirectionalLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let ae=D.shadow,ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize=ae.mapSize,n.directionalShadow[m]=ce,n.directionalShadowMap[m]=fe,n.directionalShadowMatrix[m]=D.shadow.matrix,T++}n.directional[m]=J,m++}else if(D.isSpotLight){let J=e.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(W).multiplyScalar(q),J.distance=K,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[A]=J;let ae=D.shadow;if(D.map&&(n.spotLightMap[b]=D.map,b++,ae.updateMatrices(D),D.castShadow&&L++),n.spotLightMatrix[A]=ae.matrix,D.castShadow){let ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize=ae.mapSize,n.spotShadow[A]=ce,n.spotShadowMap[A]=fe,x++}A++}else if(D.isRectAreaLight){let J=e.get(D);J.color.copy(W).multiplyScalar(q),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[S]=J,S++}else if(D.isPointLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let ae=D.shadow,ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize=ae.mapSize,ce.shadowCameraNear=ae.camera.near,ce.shadowCameraFar=ae.camera.far,n.pointShadow[v]=ce,n.pointShadowMap[v]=fe,n.pointShadowMatrix[v]=D.shadow.matrix,E++}n.point[v]=J,v++}else if(D.isHemisphereLight){let J=e.get(D);J.skyColor.copy(D.color).multiplyScalar(q),J.groundColor.copy(D.groundColor).multiplyScalar(q),n.hemi[w]=J,w++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Fe.LTC_FLOAT_1,n.rectAreaLTC2=Fe.LTC_FLOAT_2):(n.rectAreaLTC1=Fe.LTC_HALF_1,n.rectAreaLTC2=Fe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let F=n.hash;(F.sunLength!==p||F.directionalLength!==m||F.pointLength!==v||F.spotLength!==A||F.rectAreaLength!==S||F.hemiLength!==w||F.numSunShadows!==g||F.numDirectionalShadows!==T||F.numPointShadows!==E||F.numSpotShadows!==x||F.numSpotMaps!==b||F.numLightProbes!==I)&&(n.sun.length=p,n.directional.length=m,n.spot.length=A,n.rectArea.length=S,n.point.length=v,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-L,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=L,n.numLightProbes=I,F.sunLength=p,F.directionalLength=m,F.pointLength=v,F.spotLength=A,F.rectAreaLength=S,F.hemiLength=w,F.numSunShadows=g,F.numDirectionalShadows=T,F.numPointShadows=E,F.numSpotShadows=x,F.numSpotMaps=b,F.numLightProbes=I,n.version=mM++)}function l(c,h){let u=0,f=0,p=0,g=0,y=0,m=0,v=h.matrixWorldInverse;for(let A=0,S=c.length;A<S;A++){let w=c[A];if(w.isSunLight){let T=n.sun[u];T.direction.setFromMatrixPosition(w.matrixWorld),T.direction.transformDirection(v),u++}else if(w.isDirectionalLight){let T=n.directional[f];T.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(v),f++}else if(w.isSpotLight){let T=n.spot[g];T.position.setFromMatrixPosition(w.matrixWorld),T.position.applyMatrix4(v),T.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(v),g++}else if(w.isRectAreaLight){let T=n.rectArea[y];T.position.setFromMatrixPosition(w.matrixWorld),T.position.applyMatrix4(v),o.identity(),r.copy(w.matrixWorld),r.premultiply(v),o.extractRotation(r),T.halfWidth.set(w.width*.5,0,0),T.halfHeight.set(0,w.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),y++}else if(w.isPointLight){let T=n.point[p];T.position.setFromMatrixPosition(w.matrixWorld),T.position.applyMatrix4(v),p++}else if(w.isHemisphereLight){let T=n.hemi[m];T.direction.setFromMatrixPosition(w.matrixWorld),T.direction.transformDirection(v),m++}}}return{setup:a,setupView:l,state:n}}function Am(i){let e=new vM(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function _M(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Am(i),e.set(s,[a])):r>=o.length?(a=new Am(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var yM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,xM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,bM=[new $(1,0,0),new $(-1,0,0),new $(0,1,0),new $(0,-1,0),new $(0,0,1),new $(0,0,-1)],MM=[new $(0,-1,0),new $(0,-1,0),new $(0,0,1),new $(0,0,-1),new $(0,-1,0),new $(0,-1,0)],Tm=new et,Jo=new $,Pu=new $;function SM(i,e,t){let n=new ys,s=new it,r=new it,o=new wt,a=new wl,l=new Al,c={},h=t.maxTextureSize,u={[Zn]:hn,[hn]:Zn,[Ln]:Ln},f=new Ht({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:yM,fragmentShader:xM}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new Lt;g.setAttribute("position",new ut(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new At(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ho;let v=this.type;this.render=function(E,x,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===bp&&(ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ho);let L=i.getRenderTarget(),I=i.getActiveCubeFace(),F=i.getActiveMipmapLevel(),B=i.state;B.setBlending(Hs),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let z=v!==this.type;z&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(W=>W.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,W=E.length;D<W;D++){let q=E[D],K=q.shadow;if(K===void 0){ke("WebGLShadowMap:",q,"has no shadow.");continue}if(K.autoUpdate===!1&&K.needsUpdate===!1)continue;s.copy(K.mapSize);let fe=K.getFrameExtents();s.multiply(fe),r.copy(K.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/fe.x),s.x=r.x*fe.x,K.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/fe.y),s.y=r.y*fe.y,K.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(K.camera._reversedDepth=J,K.map===null||z===!0){if(K.map!==null&&(K.map.depthTexture!==null&&(K.map.depthTexture.dispose(),K.map.depthTexture=null),K.map.dispose()),this.type===Ir){if(q.isPointLight){ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}K.map=new cn(s.x,s.y,{format:Dn,type:Jt,minFilter:Et,magFilter:Et,generateMipmaps:!1}),K.map.texture.name=q.name+".shadowMap",K.map.depthTexture=new qi(s.x,s.y,_t),K.map.depthTexture.name=q.name+".shadowMapDepth",K.map.depthTexture.format=Vi,K.map.depthTexture.compareFunction=null,K.map.depthTexture.minFilter=Pt,K.map.depthTexture.magFilter=Pt}else q.isPointLight?(K.map=new Qo(s.x),K.map.depthTexture=new Co(s.x,ri)):(K.map=new cn(s.x,s.y),K.map.depthTexture=new qi(s.x,s.y,ri)),K.map.depthTexture.name=q.name+".shadowMap",K.map.depthTexture.format=Vi,this.type===Ho?(K.map.depthTexture.compareFunction=J?yu:_u,K.map.depthTexture.minFilter=Et,K.map.depthTexture.magFilter=Et):(K.map.depthTexture.compareFunction=null,K.map.depthTexture.minFilter=Pt,K.map.depthTexture.magFilter=Pt);K.camera.updateProjectionMatrix()}K.map.isWebGLCubeRenderTarget!==!0&&(K.map.width!==s.x||K.map.height!==s.y)&&K.map.setSize(s.x,s.y);let ae=K.map.isWebGLCubeRenderTarget?6:K.getViewportCount();q.isPointLight!==!0&&K.updateMatrices(q,b);let ce=(K.camera.layers.mask&4294967294)!==0?K.camera.layers:b.layers;for(let we=0;we<ae;we++){let De=K.getCamera(we);if(q.isPointLight){let ie=K.camera,Re=K.matrix,Ue=q.distance||ie.far;Ue!==ie.far&&(ie.far=Ue,ie.updateProjectionMatrix()),Jo.setFromMatrixPosition(q.matrixWorld),ie.position.copy(Jo),Pu.copy(ie.position),Pu.add(bM[we]),ie.up.copy(MM[we]),ie.lookAt(Pu),ie.updateMatrixWorld(),Re.makeTranslation(-Jo.x,-Jo.y,-Jo.z),Tm.multiplyMatrices(ie.projectionMatrix,ie.matrixWorldInverse),K._frustum.setFromProjectionMatrix(Tm,ie.coordinateSystem,ie.reversedDepth)}if(K.map.isWebGLCubeRenderTarget)i.setRenderTarget(K.map,we),i.clear();else{we===0&&(i.setRenderTarget(K.map),i.clear());let ie=K.getViewport(we);o.set(r.x*ie.x,r.y*ie.y,r.x*ie.z,r.y*ie.w),B.viewport(o)}n=K.getFrustum(we),w(x,b,De,q,ce,this.type)}K.isPointLightShadow!==!0&&this.type===Ir&&A(K,b),K.needsUpdate=!1}v=this.type,m.needsUpdate=!1,i.setRenderTarget(L,I,F)};function A(E,x){let b=e.update(y);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,p.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),E.mapPass===null?E.mapPass=new cn(s.x,s.y,{format:Dn,type:Jt}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),f.uniforms.shadow_pass.value=E.map.depthTexture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,f,y,null),p.uniforms.shadow_pass.value=E.mapPass.texture,p.uniforms.resolution.value.set(E.map.width,E.map.height),p.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,p,y,null)}function S(E,x,b,L){let I=null,F=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(F!==void 0)I=F;else if(I=b.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=I.uuid,z=x.uuid,D=c[B];D===void 0&&(D={},c[B]=D);let W=D[z];W===void 0&&(W=I.clone(),D[z]=W,x.addEventListener("dispose",T)),I=W}if(I.visible=x.visible,I.wireframe=x.wireframe,L===Ir?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:u[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=i.properties.get(I);B.light=b}return I}function w(E,x,b,L,I,F){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&F===Ir)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let D=e.update(E),W=E.material;if(Array.isArray(W)){let q=D.groups;for(let K=0,fe=q.length;K<fe;K++){let J=q[K],ae=W[J.materialIndex];if(ae&&ae.visible){let ce=S(E,ae,L,F);E.onBeforeShadow(i,E,x,b,D,ce,J),i.renderBufferDirect(b,null,D,ce,E,J),E.onAfterShadow(i,E,x,b,D,ce,J)}}}else if(W.visible){let q=S(E,W,L,F);E.onBeforeShadow(i,E,x,b,D,q,null),i.renderBufferDirect(b,null,D,q,E,null),E.onAfterShadow(i,E,x,b,D,q,null)}}let z=E.children;for(let D=0,W=z.length;D<W;D++)w(z[D],x,b,L,I,F)}function T(E){E.target.removeEventListener("dispose",T);for(let b in c){let L=c[b],I=E.target.uuid;I in L&&(L[I].dispose(),delete L[I])}}}function wM(i,e){function t(){let k=!1,ne=new wt,j=null,Ae=new wt(0,0,0,0);return{setMask:function(ve){j!==ve&&!k&&(i.colorMask(ve,ve,ve,ve),j=ve)},setLocked:function(ve){k=ve},setClear:function(ve,Se,Be,tt,_e){_e===!0&&(ve*=tt,Se*=tt,Be*=tt),ne.set(ve,Se,Be,tt),Ae.equals(ne)===!1&&(i.clearColor(ve,Se,Be,tt),Ae.copy(ne))},reset:function(){k=!1,j=null,Ae.set(-1,0,0,0)}}}function n(){let k=!1,ne=!1,j=null,Ae=null,ve=null;return{setReversed:function(Se){if(ne!==Se){let Be=e.get("EXT_clip_control");Se?Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.ZERO_TO_ONE_EXT):Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.NEGATIVE_ONE_TO_ONE_EXT),ne=Se;let tt=ve;ve=null,this.setClear(tt)}},getReversed:function(){return ne},setTest:function(Se){Se?me(i.DEPTH_TEST):$e(i.DEPTH_TEST)},setMask:function(Se){j!==Se&&!k&&(i.depthMask(Se),j=Se)},setFunc:function(Se){if(ne&&(Se=tm[Se]),Ae!==Se){switch(Se){case ll:i.depthFunc(i.NEVER);break;case cl:i.depthFunc(i.ALWAYS);break;case hl:i.depthFunc(i.LESS);break;case mr:i.depthFunc(i.LEQUAL);break;case ul:i.depthFunc(i.EQUAL);break;case fl:i.depthFunc(i.GEQUAL);break;case dl:i.depthFunc(i.GREATER);break;case pl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ae=Se}},setLocked:function(Se){k=Se},setClear:function(Se){ve!==Se&&(ve=Se,ne&&(Se=1-Se),i.clearDepth(Se))},reset:function(){k=!1,j=null,Ae=null,ve=null,ne=!1}}}function s(){let k=!1,ne=null,j=null,Ae=null,ve=null,Se=null,Be=null,tt=null,_e=null;return{setTest:function(He){k||(He?me(i.STENCIL_TEST):$e(i.STENCIL_TEST))},setMask:function(He){ne!==He&&!k&&(i.stencilMask(He),ne=He)},setFunc:function(He,Qe,Le){(j!==He||Ae!==Qe||ve!==Le)&&(i.stencilFunc(He,Qe,Le),j=He,Ae=Qe,ve=Le)},setOp:function(He,Qe,Le){(Se!==He||Be!==Qe||tt!==Le)&&(i.stencilOp(He,Qe,Le),Se=He,Be=Qe,tt=Le)},setLocked:function(He){k=He},setClear:function(He){_e!==He&&(i.clearStencil(He),_e=He)},reset:function(){k=!1,ne=null,j=null,Ae=null,ve=null,Se=null,Be=null,tt=null,_e=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},f={},p=new WeakMap,g=[],y=null,m=!1,v=null,A=null,S=null,w=null,T=null,E=null,x=null,b=new Xe(0,0,0),L=0,I=!1,F=null,B=null,z=null,D=null,W=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),K=!1,fe=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(fe=parseFloat(/^WebGL (\d)/.exec(J)[1]),K=fe>=1):J.indexOf("OpenGL ES")!==-1&&(fe=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),K=fe>=2);let ae=null,ce={},we=i.getParameter(i.SCISSOR_BOX),De=i.getParameter(i.VIEWPORT),ie=new wt().fromArray(we),Re=new wt().fromArray(De);function Ue(k,ne,j,Ae){let ve=new Uint8Array(4),Se=i.createTexture();i.bindTexture(k,Se),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Be=0;Be<j;Be++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(ne,0,i.RGBA,1,1,Ae,0,i.RGBA,i.UNSIGNED_BYTE,ve):i.texImage2D(ne+Be,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ve);return Se}let ze={};ze[i.TEXTURE_2D]=Ue(i.TEXTURE_2D,i.TEXTURE_2D,1),ze[i.TEXTURE_CUBE_MAP]=Ue(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ze[i.TEXTURE_2D_ARRAY]=Ue(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ze[i.TEXTURE_3D]=Ue(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),me(i.DEPTH_TEST),o.setFunc(mr),sn(!1),Dt(Qh),me(i.CULL_FACE),Vt(Hs);function me(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function $e(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function Mt(k,ne){return f[k]!==ne?(i.bindFramebuffer(k,ne),f[k]=ne,k===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ne),k===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ne),!0):!1}function Ve(k,ne){let j=g,Ae=!1;if(k){j=p.get(ne),j===void 0&&(j=[],p.set(ne,j));let ve=k.textures;if(j.length!==ve.length||j[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,Be=ve.length;Se<Be;Se++)j[Se]=i.COLOR_ATTACHMENT0+Se;j.length=ve.length,Ae=!0}}else j[0]!==i.BACK&&(j[0]=i.BACK,Ae=!0);Ae&&i.drawBuffers(j)}function ft(k){return y!==k?(i.useProgram(k),y=k,!0):!1}let mt={[Gs]:i.FUNC_ADD,[Sp]:i.FUNC_SUBTRACT,[wp]:i.FUNC_REVERSE_SUBTRACT};mt[Ap]=i.MIN,mt[Tp]=i.MAX;let at={[Ep]:i.ZERO,[Rp]:i.ONE,[Cp]:i.SRC_COLOR,[iu]:i.SRC_ALPHA,[Fp]:i.SRC_ALPHA_SATURATE,[Np]:i.DST_COLOR,[Pp]:i.DST_ALPHA,[Ip]:i.ONE_MINUS_SRC_COLOR,[su]:i.ONE_MINUS_SRC_ALPHA,[Dp]:i.ONE_MINUS_DST_COLOR,[Lp]:i.ONE_MINUS_DST_ALPHA,[Up]:i.CONSTANT_COLOR,[Op]:i.ONE_MINUS_CONSTANT_COLOR,[Bp]:i.CONSTANT_ALPHA,[kp]:i.ONE_MINUS_CONSTANT_ALPHA};function Vt(k,ne,j,Ae,ve,Se,Be,tt,_e,He){if(k===Hs){m===!0&&($e(i.BLEND),m=!1);return}if(m===!1&&(me(i.BLEND),m=!0),k!==Mp){if(k!==v||He!==I){if((A!==Gs||T!==Gs)&&(i.blendEquation(i.FUNC_ADD),A=Gs,T=Gs),He)switch(k){case Pr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case eu:i.blendFunc(i.ONE,i.ONE);break;case tu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case nu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ke("WebGLState: Invalid blending: ",k);break}else switch(k){case Pr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case eu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case tu:Ke("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case nu:Ke("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ke("WebGLState: Invalid blending: ",k);break}S=null,w=null,E=null,x=null,b.set(0,0,0),L=0,v=k,I=He}return}ve=ve||ne,Se=Se||j,Be=Be||Ae,(ne!==A||ve!==T)&&(i.blendEquationSeparate(mt[ne],mt[ve]),A=ne,T=ve),(j!==S||Ae!==w||Se!==E||Be!==x)&&(i.blendFuncSeparate(at[j],at[Ae],at[Se],at[Be]),S=j,w=Ae,E=Se,x=Be),(tt.equals(b)===!1||_e!==L)&&(i.blendColor(tt.r,tt.g,tt.b,_e),b.copy(tt),L=_e),v=k,I=!1}function Bt(k,ne){k.side===Ln?$e(i.CULL_FACE):me(i.CULL_FACE);let j=k.side===hn;ne&&(j=!j),sn(j),k.blending===Pr&&k.transparent===!1?Vt(Hs):Vt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ae=k.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),qt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?me(i.SAMPLE_ALPHA_TO_COVERAGE):$e(i.SAMPLE_ALPHA_TO_COVERAGE)}function sn(k){F!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),F=k)}function Dt(k){k!==yp?(me(i.CULL_FACE),k!==B&&(k===Qh?i.cullFace(i.BACK):k===xp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$e(i.CULL_FACE),B=k}function Wn(k){k!==z&&(K&&i.lineWidth(k),z=k)}function qt(k,ne,j){k?(me(i.POLYGON_OFFSET_FILL),(D!==ne||W!==j)&&(D=ne,W=j,o.getReversed()&&(ne=-ne,j=-j),i.polygonOffset(ne,j))):$e(i.POLYGON_OFFSET_FILL)}function vn(k){k?me(i.SCISSOR_TEST):$e(i.SCISSOR_TEST)}function _n(k){k===void 0&&(k=i.TEXTURE0+q-1),ae!==k&&(i.activeTexture(k),ae=k)}function An(k,ne,j){j===void 0&&(ae===null?j=i.TEXTURE0+q-1:j=ae);let Ae=ce[j];Ae===void 0&&(Ae={type:void 0,texture:void 0},ce[j]=Ae),(Ae.type!==k||Ae.texture!==ne)&&(ae!==j&&(i.activeTexture(j),ae=j),i.bindTexture(k,ne||ze[k]),Ae.type=k,Ae.texture=ne)}function V(){let k=ce[ae];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function yn(){try{i.compressedTexImage2D(...arguments)}catch(k){Ke("WebGLState:",k)}}function Rt(){try{i.compressedTexImage3D(...arguments)}catch(k){Ke("WebGLState:",k)}}function Ct(){try{i.texSubImage2D(...arguments)}catch(k){Ke("WebGLState:",k)}}function Ce(){try{i.texSubImage3D(...arguments)}catch(k){Ke("WebGLState:",k)}}function Yt(){try{i.compressedTexSubImage2D(...arguments)}catch(k){Ke("WebGLState:",k)}}function Ge(){try{i.compressedTexSubImage3D(...arguments)}catch(k){Ke("WebGLState:",k)}}function je(){try{i.texStorage2D(...arguments)}catch(k){Ke("WebGLState:",k)}}function O(){try{i.texStorage3D(...arguments)}catch(k){Ke("WebGLState:",k)}}function R(){try{i.texImage2D(...arguments)}catch(k){Ke("WebGLState:",k)}}function Z(){try{i.texImage3D(...arguments)}catch(k){Ke("WebGLState:",k)}}function ge(k){return u[k]!==void 0?u[k]:i.getParameter(k)}function le(k,ne){u[k]!==ne&&(i.pixelStorei(k,ne),u[k]=ne)}function be(k){ie.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),ie.copy(k))}function Ie(k){Re.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),Re.copy(k))}function te(k,ne){let j=c.get(ne);j===void 0&&(j=new WeakMap,c.set(ne,j));let Ae=j.get(k);Ae===void 0&&(Ae=i.getUniformBlockIndex(ne,k.name),i.uniformBlockBinding(ne,Ae,Ae),j.set(k,Ae))}function se(k,ne,j){let ve=c.get(ne).get(k);l[ve]!==j&&(i.bindBufferBase(i.UNIFORM_BUFFER,ve,j),l[ve]=j)}function Me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ae=null,ce={},f={},l={},p=new WeakMap,g=[],y=null,m=!1,v=null,A=null,S=null,w=null,T=null,E=null,x=null,b=new Xe(0,0,0),L=0,I=!1,F=null,B=null,z=null,D=null,W=null,ie.set(0,0,i.canvas.width,i.canvas.height),Re.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:me,disable:$e,bindFramebuffer:Mt,drawBuffers:Ve,useProgram:ft,setBlending:Vt,setMaterial:Bt,setFlipSided:sn,setCullFace:Dt,setLineWidth:Wn,setPolygonOffset:qt,setScissorTest:vn,activeTexture:_n,bindTexture:An,unbindTexture:V,compressedTexImage2D:yn,compressedTexImage3D:Rt,texImage2D:R,texImage3D:Z,pixelStorei:le,getParameter:ge,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:je,texStorage3D:O,texSubImage2D:Ct,texSubImage3D:Ce,compressedTexSubImage2D:Yt,compressedTexSubImage3D:Ge,scissor:be,viewport:Ie,reset:Me}}function AM(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,h=new WeakMap,u=new Set,f,p=new WeakMap,g=new Set,y=new FinalizationRegistry(O=>g.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(O,R){return m?new OffscreenCanvas(O,R):_r("canvas")}function A(O,R,Z){let ge=1,le=je(O);if((le.width>Z||le.height>Z)&&(ge=Z/Math.max(le.width,le.height)),ge<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let be=Math.floor(ge*le.width),Ie=Math.floor(ge*le.height);f===void 0&&(f=v(be,Ie));let te=R?v(be,Ie):f;return te.width=be,te.height=Ie,te.getContext("2d").drawImage(O,0,0,be,Ie),ke("WebGLRenderer: Texture has been resized from ("+le.width+"x"+le.height+") to ("+be+"x"+Ie+")."),te}else return"data"in O&&ke("WebGLRenderer: Image in DataTexture is too big ("+le.width+"x"+le.height+")."),O;return O}function S(O){return O.generateMipmaps}function w(O){i.generateMipmap(O)}function T(O){return O.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?i.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(O,R,Z,ge,le,be=!1){if(O!==null){if(i[O]!==void 0)return i[O];ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let Ie;ge&&(Ie=e.get("EXT_texture_norm16"),Ie||ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=R;if(R===i.RED&&(Z===i.FLOAT&&(te=i.R32F),Z===i.HALF_FLOAT&&(te=i.R16F),Z===i.UNSIGNED_BYTE&&(te=i.R8),Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.R16_EXT),Z===i.SHORT&&Ie&&(te=Ie.R16_SNORM_EXT)),R===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.R8UI),Z===i.UNSIGNED_SHORT&&(te=i.R16UI),Z===i.UNSIGNED_INT&&(te=i.R32UI),Z===i.BYTE&&(te=i.R8I),Z===i.SHORT&&(te=i.R16I),Z===i.INT&&(te=i.R32I)),R===i.RG&&(Z===i.FLOAT&&(te=i.RG32F),Z===i.HALF_FLOAT&&(te=i.RG16F),Z===i.UNSIGNED_BYTE&&(te=i.RG8),Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.RG16_EXT),Z===i.SHORT&&Ie&&(te=Ie.RG16_SNORM_EXT)),R===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.RG8UI),Z===i.UNSIGNED_SHORT&&(te=i.RG16UI),Z===i.UNSIGNED_INT&&(te=i.RG32UI),Z===i.BYTE&&(te=i.RG8I),Z===i.SHORT&&(te=i.RG16I),Z===i.INT&&(te=i.RG32I)),R===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(te=i.RGB16UI),Z===i.UNSIGNED_INT&&(te=i.RGB32UI),Z===i.BYTE&&(te=i.RGB8I),Z===i.SHORT&&(te=i.RGB16I),Z===i.INT&&(te=i.RGB32I)),R===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),Z===i.UNSIGNED_INT&&(te=i.RGBA32UI),Z===i.BYTE&&(te=i.RGBA8I),Z===i.SHORT&&(te=i.RGBA16I),Z===i.INT&&(te=i.RGBA32I)),R===i.RGB&&(Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.RGB16_EXT),Z===i.SHORT&&Ie&&(te=Ie.RGB16_SNORM_EXT),Z===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),Z===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),R===i.RGBA){let se=be?mo:rt.getTransfer(le);Z===i.FLOAT&&(te=i.RGBA32F),Z===i.HALF_FLOAT&&(te=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(te=se===bt?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.RGBA16_EXT),Z===i.SHORT&&Ie&&(te=Ie.RGBA16_SNORM_EXT),Z===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(O,R){let Z;return O?R===null||R===ri||R===$s?Z=i.DEPTH24_STENCIL8:R===_t?Z=i.DEPTH32F_STENCIL8:R===Fr&&(Z=i.DEPTH24_STENCIL8,ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===ri||R===$s?Z=i.DEPTH_COMPONENT24:R===_t?Z=i.DEPTH_COMPONENT32F:R===Fr&&(Z=i.DEPTH_COMPONENT16),Z}function b(O,R){return S(O)===!0||O.isFramebufferTexture&&O.minFilter!==Pt&&O.minFilter!==Et?Math.log2(Math.max(R.width,R.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?R.mipmaps.length:1}function L(O){let R=new WeakRef(O);n.get(O).__ref=R,g.add(R),y.register(O,R,R)}function I(O){let R=n.get(O).__ref;R!==void 0&&(g.delete(R),y.unregister(R))}function F(O){z(O.target)}function B(O){D(O.target)}function z(O){O.removeEventListener("dispose",F),I(O),q(O),O.isVideoTexture&&h.delete(O),O.isHTMLTexture&&u.delete(O)}function D(O){O.removeEventListener("dispose",B),I(O),fe(O)}function W(){for(let O of g){let R=O.deref();R!==void 0&&(R.isRenderTarget===!0?D(R):z(R))}g.clear(),u.clear()}function q(O){let R=n.get(O);if(R.__webglInit===void 0)return;let Z=O.source,ge=p.get(Z);if(ge){let le=ge[R.__cacheKey];le.usedTimes--,le.usedTimes===0&&K(O),Object.keys(ge).length===0&&p.delete(Z)}n.remove(O)}function K(O){let R=n.get(O);i.deleteTexture(R.__webglTexture);let Z=O.source,ge=p.get(Z);delete ge[R.__cacheKey],o.memory.textures--}function fe(O){let R=n.get(O);R.__depthDisposeCallback&&R.__depthDisposeCallback();let Z=O.depthTexture;if(Z&&Z.renderTarget===O&&z(Z),O.isWebGLCubeRenderTarget)for(let le=0;le<6;le++){if(Array.isArray(R.__webglFramebuffer[le]))for(let be=0;be<R.__webglFramebuffer[le].length;be++)i.deleteFramebuffer(R.__webglFramebuffer[le][be]);else i.deleteFramebuffer(R.__webglFramebuffer[le]);R.__webglDepthbuffer&&i.deleteRenderbuffer(R.__webglDepthbuffer[le])}else{if(Array.isArray(R.__webglFramebuffer))for(let le=0;le<R.__webglFramebuffer.length;le++)i.deleteFramebuffer(R.__webglFramebuffer[le]);else i.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&i.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&i.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let le=0;le<R.__webglColorRenderbuffer.length;le++)R.__webglColorRenderbuffer[le]&&i.deleteRenderbuffer(R.__webglColorRenderbuffer[le]);R.__webglDepthRenderbuffer&&i.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let ge=O.textures;for(let le=0,be=ge.length;le<be;le++){let Ie=n.get(ge[le]);Ie.__webglTexture&&(i.deleteTexture(Ie.__webglTexture),o.memory.textures--),n.remove(ge[le])}n.remove(O)}let J=0;function ae(){J=0}function ce(){return J}function we(O){J=O}function De(){let O=J;return O>=s.maxTextures&&ke("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,O}function ie(O){let R=[];return R.push(O.wrapS),R.push(O.wrapT),R.push(O.wrapR||0),R.push(O.magFilter),R.push(O.minFilter),R.push(O.anisotropy),R.push(O.internalFormat),R.push(O.format),R.push(O.type),R.push(O.generateMipmaps),R.push(O.mipmapsAutoUpdate),R.push(O.premultiplyAlpha),R.push(O.flipY),R.push(O.unpackAlignment),R.push(O.colorSpace),R.join()}function Re(O,R){let Z=n.get(O);if(O.isVideoTexture&&Yt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&Z.__version!==O.version){let ge=O.image;if(ge===null)ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ge.complete===!1)ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Bt(Z,O,R);return}}else O.isExternalTexture&&(Z.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+R)}function Ue(O,R){let Z=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Z.__version!==O.version){Bt(Z,O,R);return}else O.isExternalTexture&&(Z.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+R)}function ze(O,R){let Z=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Z.__version!==O.version){Bt(Z,O,R);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+R)}function me(O,R){let Z=n.get(O);if(O.version>0&&Z.__version!==O.version){sn(Z,O,R);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+R)}let $e={[_s]:i.REPEAT,[Rn]:i.CLAMP_TO_EDGE,[gr]:i.MIRRORED_REPEAT},Mt={[Pt]:i.NEAREST,[Ul]:i.NEAREST_MIPMAP_NEAREST,[Ws]:i.NEAREST_MIPMAP_LINEAR,[Et]:i.LINEAR,[Dr]:i.LINEAR_MIPMAP_NEAREST,[Vn]:i.LINEAR_MIPMAP_LINEAR},Ve={[qp]:i.NEVER,[xu]:i.ALWAYS,[Yp]:i.LESS,[_u]:i.LEQUAL,[Zp]:i.EQUAL,[yu]:i.GEQUAL,[Kp]:i.GREATER,[Jp]:i.NOTEQUAL};function ft(O,R){if(R.type===_t&&e.has("OES_texture_float_linear")===!1&&(R.magFilter===Et||R.magFilter===Dr||R.magFilter===Ws||R.magFilter===Vn||R.minFilter===Et||R.minFilter===Dr||R.minFilter===Ws||R.minFilter===Vn)&&ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(O,i.TEXTURE_WRAP_S,$e[R.wrapS]),i.texParameteri(O,i.TEXTURE_WRAP_T,$e[R.wrapT]),(O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY)&&i.texParameteri(O,i.TEXTURE_WRAP_R,$e[R.wrapR]),i.texParameteri(O,i.TEXTURE_MAG_FILTER,Mt[R.magFilter]),i.texParameteri(O,i.TEXTURE_MIN_FILTER,Mt[R.minFilter]),R.compareFunction&&(i.texParameteri(O,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(O,i.TEXTURE_COMPARE_FUNC,Ve[R.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Pt||R.minFilter!==Ws&&R.minFilter!==Vn||R.type===_t&&e.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||n.get(R).__currentAnisotropy){let Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(O,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),n.get(R).__currentAnisotropy=R.anisotropy}}}function mt(O,R){let Z=!1;O.__webglInit===void 0&&(O.__webglInit=!0,R.addEventListener("dispose",F),L(R));let ge=R.source,le=p.get(ge);le===void 0&&(le={},p.set(ge,le));let be=ie(R);if(be!==O.__cacheKey){le[be]===void 0&&(le[be]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),le[be].usedTimes++;let Ie=le[O.__cacheKey];Ie!==void 0&&(le[O.__cacheKey].usedTimes--,Ie.usedTimes===0&&K(R)),O.__cacheKey=be,O.__webglTexture=le[be].texture}return Z}function at(O,R,Z){return Math.floor(Math.floor(O/Z)/R)}function Vt(O,R,Z,ge){let be=O.updateRanges;if(be.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,R.width,R.height,Z,ge,R.data);else{be.sort((k,ne)=>k.start-ne.start);let Ie=0;for(let k=1;k<be.length;k++){let ne=be[Ie],j=be[k],Ae=ne.start+ne.count,ve=at(j.start,R.width,4),Se=at(ne.start,R.width,4);j.start<=Ae+1&&ve===Se&&at(j.start+j.count-1,R.width,4)===ve?ne.count=Math.max(ne.count,j.start+j.count-ne.start):(++Ie,be[Ie]=j)}be.length=Ie+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),Me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,R.width);for(let k=0,ne=be.length;k<ne;k++){let j=be[k],Ae=Math.floor(j.start/4),ve=Math.ceil(j.count/4),Se=Ae%R.width,Be=Math.floor(Ae/R.width),tt=ve,_e=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Be),t.texSubImage2D(i.TEXTURE_2D,0,Se,Be,tt,_e,Z,ge,R.data)}O.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Me)}}function Bt(O,R,Z){let ge=i.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(ge=i.TEXTURE_2D_ARRAY),R.isData3DTexture&&(ge=i.TEXTURE_3D);let le=mt(O,R),be=R.source;t.bindTexture(ge,O.__webglTexture,i.TEXTURE0+Z);let Ie=n.get(be);if(be.version!==Ie.__version||le===!0){if(t.activeTexture(i.TEXTURE0+Z),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let _e=rt.getPrimaries(rt.workingColorSpace),He=R.colorSpace===ns?null:rt.getPrimaries(R.colorSpace),Qe=R.colorSpace===ns||_e===He?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,R.unpackAlignment);let se=A(R.image,!1,s.maxTextureSize);se=Ge(R,se);let Me=r.convert(R.format,R.colorSpace),k=r.convert(R.type),ne=E(R.internalFormat,Me,k,R.normalized,R.colorSpace,R.isVideoTexture);ft(ge,R);let j,Ae=R.mipmaps,ve=R.isVideoTexture!==!0,Se=Ie.__version===void 0||le===!0,Be=be.dataReady,tt=b(R,se);if(R.isDepthTexture)ne=x(R.format===es,R.type),Se&&(ve?t.texStorage2D(i.TEXTURE_2D,1,ne,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,ne,se.width,se.height,0,Me,k,null));else if(R.isDataTexture)if(Ae.length>0){ve&&Se&&t.texStorage2D(i.TEXTURE_2D,tt,ne,Ae[0].width,Ae[0].height);for(let _e=0,He=Ae.length;_e<He;_e++)j=Ae[_e],ve?Be&&t.texSubImage2D(i.TEXTURE_2D,_e,0,0,j.width,j.height,Me,k,j.data):t.texImage2D(i.TEXTURE_2D,_e,ne,j.width,j.height,0,Me,k,j.data);R.generateMipmaps=!1}else ve?(Se&&t.texStorage2D(i.TEXTURE_2D,tt,ne,se.width,se.height),Be&&Vt(R,se,Me,k)):t.texImage2D(i.TEXTURE_2D,0,ne,se.width,se.height,0,Me,k,se.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){ve&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,ne,Ae[0].width,Ae[0].height,se.depth);for(let _e=0,He=Ae.length;_e<He;_e++)if(j=Ae[_e],R.format!==yt)if(Me!==null)if(ve){if(Be)if(R.layerUpdates.size>0){let Qe=Cu(j.width,j.height,R.format,R.type);for(let Le of R.layerUpdates){let vt=j.data.subarray(Le*Qe/j.data.BYTES_PER_ELEMENT,(Le+1)*Qe/j.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,_e,0,0,Le,j.width,j.height,1,Me,vt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,_e,0,0,0,j.width,j.height,se.depth,Me,j.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,_e,ne,j.width,j.height,se.depth,0,j.data,0,0);else ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ve?Be&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,_e,0,0,0,j.width,j.height,se.depth,Me,k,j.data):t.texImage3D(i.TEXTURE_2D_ARRAY,_e,ne,j.width,j.height,se.depth,0,Me,k,j.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{ve&&Se&&t.texStorage2D(i.TEXTURE_2D,tt,ne,Ae[0].width,Ae[0].height);for(let _e=0,He=Ae.length;_e<He;_e++)j=Ae[_e],R.format!==yt?Me!==null?ve?Be&&t.compressedTexSubImage2D(i.TEXTURE_2D,_e,0,0,j.width,j.height,Me,j.data):t.compressedTexImage2D(i.TEXTURE_2D,_e,ne,j.width,j.height,0,j.data):ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ve?Be&&t.texSubImage2D(i.TEXTURE_2D,_e,0,0,j.width,j.height,Me,k,j.data):t.texImage2D(i.TEXTURE_2D,_e,ne,j.width,j.height,0,Me,k,j.data)}else if(R.isDataArrayTexture)if(ve){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,ne,se.width,se.height,se.depth),Be)if(R.layerUpdates.size>0){let _e=Cu(se.width,se.height,R.format,R.type);for(let He of R.layerUpdates){let Qe=se.data.subarray(He*_e/se.data.BYTES_PER_ELEMENT,(He+1)*_e/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,He,se.width,se.height,1,Me,k,Qe)}R.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,Me,k,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ne,se.width,se.height,se.depth,0,Me,k,se.data);else if(R.isData3DTexture)ve?(Se&&t.texStorage3D(i.TEXTURE_3D,tt,ne,se.width,se.height,se.depth),Be&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,Me,k,se.data)):t.texImage3D(i.TEXTURE_3D,0,ne,se.width,se.height,se.depth,0,Me,k,se.data);else if(R.isFramebufferTexture){if(Se)if(ve)t.texStorage2D(i.TEXTURE_2D,tt,ne,se.width,se.height);else{let _e=se.width,He=se.height;for(let Qe=0;Qe<tt;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,ne,_e,He,0,Me,k,null),_e>>=1,He>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in i){let _e=i.canvas;if(_e.hasAttribute("layoutsubtree")||_e.setAttribute("layoutsubtree","true"),se.parentNode!==_e){_e.appendChild(se),u.add(R),_e.onpaint=He=>{let Qe=He.changedElements;for(let Le of u)Qe.includes(Le.image)&&(Le.needsUpdate=!0)},_e.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Qe=i.RGBA,Le=i.RGBA,vt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Le,vt,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ve&&Se){let _e=je(Ae[0]);t.texStorage2D(i.TEXTURE_2D,tt,ne,_e.width,_e.height)}for(let _e=0,He=Ae.length;_e<He;_e++)j=Ae[_e],ve?Be&&t.texSubImage2D(i.TEXTURE_2D,_e,0,0,Me,k,j):t.texImage2D(i.TEXTURE_2D,_e,ne,Me,k,j);R.generateMipmaps=!1}else if(ve){if(Se){let _e=je(se);t.texStorage2D(i.TEXTURE_2D,tt,ne,_e.width,_e.height)}Be&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Me,k,se)}else t.texImage2D(i.TEXTURE_2D,0,ne,Me,k,se);S(R)&&R.mipmapsAutoUpdate===!0&&w(ge),Ie.__version=be.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function sn(O,R,Z){if(R.image.length!==6)return;let ge=mt(O,R),le=R.source;t.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+Z);let be=n.get(le);if(le.version!==be.__version||ge===!0){t.activeTexture(i.TEXTURE0+Z);let Ie=rt.getPrimaries(rt.workingColorSpace),te=R.colorSpace===ns?null:rt.getPrimaries(R.colorSpace),se=R.colorSpace===ns||Ie===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,R.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let Me=R.isCompressedTexture||R.image[0].isCompressedTexture,k=R.image[0]&&R.image[0].isDataTexture,ne=[];for(let Le=0;Le<6;Le++)!Me&&!k?ne[Le]=A(R.image[Le],!0,s.maxCubemapSize):ne[Le]=k?R.image[Le].image:R.image[Le],ne[Le]=Ge(R,ne[Le]);let j=ne[0],Ae=r.convert(R.format,R.colorSpace),ve=r.convert(R.type),Se=E(R.internalFormat,Ae,ve,R.normalized,R.colorSpace),Be=R.isVideoTexture!==!0,tt=be.__version===void 0||ge===!0,_e=le.dataReady,He=b(R,j);ft(i.TEXTURE_CUBE_MAP,R);let Qe;if(R.isDepthTexture){if(Se=x(R.format===es,R.type),tt)if(Be)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,j.width,j.height);else for(let Le=0;Le<6;Le++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,Se,j.width,j.height,0,Ae,ve,null)}else if(Me){Be&&tt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Se,j.width,j.height);for(let Le=0;Le<6;Le++){Qe=ne[Le].mipmaps;for(let vt=0;vt<Qe.length;vt++){let jt=Qe[vt];R.format!==yt?Ae!==null?Be?_e&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,0,0,jt.width,jt.height,Ae,jt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,Se,jt.width,jt.height,0,jt.data):ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,0,0,jt.width,jt.height,Ae,ve,jt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,Se,jt.width,jt.height,0,Ae,ve,jt.data)}}}else{if(Qe=R.mipmaps,Be&&tt){Qe.length>0&&He++;let Le=je(ne[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Se,Le.width,Le.height)}for(let Le=0;Le<6;Le++)if(k){Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,0,0,ne[Le].width,ne[Le].height,Ae,ve,ne[Le].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,Se,ne[Le].width,ne[Le].height,0,Ae,ve,ne[Le].data);for(let vt=0;vt<Qe.length;vt++){let ci=Qe[vt].image[Le].image;Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,0,0,ci.width,ci.height,Ae,ve,ci.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,Se,ci.width,ci.height,0,Ae,ve,ci.data)}}else{Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,0,0,Ae,ve,ne[Le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,Se,Ae,ve,ne[Le]);for(let vt=0;vt<Qe.length;vt++){let jt=Qe[vt];Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,0,0,Ae,ve,jt.image[Le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,Se,Ae,ve,jt.image[Le])}}}S(R)&&R.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),be.__version=le.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function Dt(O,R,Z,ge,le,be){let Ie=r.convert(Z.format,Z.colorSpace),te=r.convert(Z.type),se=E(Z.internalFormat,Ie,te,Z.normalized,Z.colorSpace),Me=n.get(R),k=n.get(Z);if(k.__renderTarget=R,!Me.__hasExternalTextures){let ne=Math.max(1,R.width>>be),j=Math.max(1,R.height>>be);le===i.TEXTURE_3D||le===i.TEXTURE_2D_ARRAY?t.texImage3D(le,be,se,ne,j,R.depth,0,Ie,te,null):t.texImage2D(le,be,se,ne,j,0,Ie,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,O),Ce(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ge,le,k.__webglTexture,0,Ct(R)):(le===i.TEXTURE_2D||le>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&le<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ge,le,k.__webglTexture,be),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Wn(O,R,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,O),R.depthBuffer){let ge=R.depthTexture,le=ge&&ge.isDepthTexture?ge.type:null,be=x(R.stencilBuffer,le),Ie=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ce(R)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ct(R),be,R.width,R.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ct(R),be,R.width,R.height):i.renderbufferStorage(i.RENDERBUFFER,be,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ie,i.RENDERBUFFER,O)}else{let ge=R.textures;for(let le=0;le<ge.length;le++){let be=ge[le],Ie=r.convert(be.format,be.colorSpace),te=r.convert(be.type),se=E(be.internalFormat,Ie,te,be.normalized,be.colorSpace);Ce(R)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ct(R),se,R.width,R.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ct(R),se,R.width,R.height):i.renderbufferStorage(i.RENDERBUFFER,se,R.width,R.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function qt(O,R,Z){let ge=R.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,O),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let le=n.get(R.depthTexture);le.__renderTarget=R;let be=ge?R.depthTexture.image[0]:R.depthTexture.image;(!le.__webglTexture||be.width!==R.width||be.height!==R.height)&&(be.width=R.width,be.height=R.height,R.depthTexture.needsUpdate=!0),ge?me(R.depthTexture,0):Re(R.depthTexture,0);let Ie=le.__webglTexture,te=Ct(R),se=ge?i.TEXTURE_CUBE_MAP_POSITIVE_X+Z:i.TEXTURE_2D,Me=R.depthTexture.format===es?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(R.depthTexture.format===Vi)Ce(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Me,se,Ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,Me,se,Ie,0);else if(R.depthTexture.format===es)Ce(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Me,se,Ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,Me,se,Ie,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vn(O){let R=n.get(O),Z=O.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==O.depthTexture){let ge=O.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),ge){let le=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,ge.removeEventListener("dispose",le)};ge.addEventListener("dispose",le),R.__depthDisposeCallback=le}R.__boundDepthTexture=ge}if(O.depthTexture&&!R.__autoAllocateDepthBuffer)if(Z)for(let ge=0;ge<6;ge++)qt(R.__webglFramebuffer[ge],O,ge);else O.texture.mipmaps.length>0?qt(R.__webglFramebuffer[0],O,0):qt(R.__webglFramebuffer,O,0);else if(Z){R.__webglDepthbuffer=[];for(let ge=0;ge<6;ge++)if(t.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer[ge]),R.__webglDepthbuffer[ge]===void 0)R.__webglDepthbuffer[ge]=i.createRenderbuffer(),Wn(R.__webglDepthbuffer[ge],O,!1);else{let le=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=R.__webglDepthbuffer[ge];i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=i.createRenderbuffer(),Wn(R.__webglDepthbuffer,O,!1);else{let le=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=R.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function _n(O,R,Z){let ge=n.get(O);R!==void 0&&Dt(ge.__webglFramebuffer,O,O.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&vn(O)}function An(O){let R=O.texture,Z=n.get(O),ge=n.get(R);O.addEventListener("dispose",B),L(O);let le=O.textures,be=O.isWebGLCubeRenderTarget===!0,Ie=le.length>1;if(Ie||(ge.__webglTexture===void 0&&(ge.__webglTexture=i.createTexture()),ge.__version=R.version,o.memory.textures++),be){Z.__webglFramebuffer=[];for(let te=0;te<6;te++)if(R.mipmaps.length>0){Z.__webglFramebuffer[te]=[];for(let se=0;se<R.mipmaps.length;se++)Z.__webglFramebuffer[te][se]=i.createFramebuffer()}else Z.__webglFramebuffer[te]=i.createFramebuffer()}else{if(R.mipmaps.length>0){Z.__webglFramebuffer=[];for(let te=0;te<R.mipmaps.length;te++)Z.__webglFramebuffer[te]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(Ie)for(let te=0,se=le.length;te<se;te++){let Me=n.get(le[te]);Me.__webglTexture===void 0&&(Me.__webglTexture=i.createTexture(),o.memory.textures++)}if(O.samples>0&&Ce(O)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let te=0;te<le.length;te++){let se=le[te];Z.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[te]);let Me=r.convert(se.format,se.colorSpace),k=r.convert(se.type),ne=E(se.internalFormat,Me,k,se.normalized,se.colorSpace,O.isXRRenderTarget===!0),j=Ct(O);i.renderbufferStorageMultisample(i.RENDERBUFFER,j,ne,O.width,O.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,Z.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),O.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),Wn(Z.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(be){t.bindTexture(i.TEXTURE_CUBE_MAP,ge.__webglTexture),ft(i.TEXTURE_CUBE_MAP,R);for(let te=0;te<6;te++)if(R.mipmaps.length>0)for(let se=0;se<R.mipmaps.length;se++)Dt(Z.__webglFramebuffer[te][se],O,R,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Dt(Z.__webglFramebuffer[te],O,R,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);S(R)?w(i.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}else if(Ie){for(let te=0,se=le.length;te<se;te++){let Me=le[te],k=n.get(Me),ne=i.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ne=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,k.__webglTexture),ft(ne,Me),Dt(Z.__webglFramebuffer,O,Me,i.COLOR_ATTACHMENT0+te,ne,0),S(Me)&&w(ne)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(te=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ge.__webglTexture),ft(te,R),R.mipmaps.length>0)for(let se=0;se<R.mipmaps.length;se++)Dt(Z.__webglFramebuffer[se],O,R,i.COLOR_ATTACHMENT0,te,se);else Dt(Z.__webglFramebuffer,O,R,i.COLOR_ATTACHMENT0,te,0);S(R)?w(te):R.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&vn(O)}function V(O){let R=O.textures;for(let Z=0,ge=R.length;Z<ge;Z++){let le=R[Z];if(S(le)&&le.mipmapsAutoUpdate===!0){let be=T(O),Ie=n.get(le).__webglTexture;t.bindTexture(be,Ie),w(be),t.unbindTexture()}}}let yn=[];function Rt(O){if(O.samples>0){if(Ce(O)===!1){let R=O.textures,Z=O.width,ge=O.height,le=i.COLOR_BUFFER_BIT,be=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ie=n.get(O),te=R.length>1;if(te)for(let Me=0;Me<R.length;Me++)t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ie.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ie.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ie.__webglFramebuffer);for(let Me=0;Me<R.length;Me++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(le|=i.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(le|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ie.__webglColorRenderbuffer[Me]);let k=n.get(R[Me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,Z,ge,0,0,Z,ge,le,i.NEAREST),l===!0&&(yn.length=0,yn.push(i.COLOR_ATTACHMENT0+Me),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&yn.push(be),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,yn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let Me=0;Me<R.length;Me++){t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.RENDERBUFFER,Ie.__webglColorRenderbuffer[Me]);let k=n.get(R[Me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ie.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let R=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[R])}}}function Ct(O){return Math.min(s.maxSamples,O.samples)}function Ce(O){let R=n.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Yt(O){let R=o.render.frame;h.get(O)!==R&&(h.set(O,R),O.update())}function Ge(O,R){let Z=O.colorSpace,ge=O.format,le=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||Z!==Ot&&Z!==ns&&(rt.getTransfer(Z)===bt?(ge!==yt||le!==Nn)&&ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ke("WebGLTextures: Unsupported texture color space:",Z)),R}function je(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=De,this.resetTextureUnits=ae,this.getTextureUnits=ce,this.setTextureUnits=we,this.setTexture2D=Re,this.setTexture2DArray=Ue,this.setTexture3D=ze,this.setTextureCube=me,this.rebindTextures=_n,this.setupRenderTarget=An,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Rt,this.setupDepthRenderbuffer=vn,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=Ce,this.dispose=W}function TM(i,e){function t(n,s=ns){let r,o=rt.getTransfer(s);if(n===Nn)return i.UNSIGNED_BYTE;if(n===Bl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===kl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===du)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===pu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===uu)return i.BYTE;if(n===fu)return i.SHORT;if(n===Fr)return i.UNSIGNED_SHORT;if(n===Ol)return i.INT;if(n===ri)return i.UNSIGNED_INT;if(n===_t)return i.FLOAT;if(n===Jt)return i.HALF_FLOAT;if(n===mu)return i.ALPHA;if(n===gu)return i.RGB;if(n===yt)return i.RGBA;if(n===Vi)return i.DEPTH_COMPONENT;if(n===es)return i.DEPTH_STENCIL;if(n===ts)return i.RED;if(n===zl)return i.RED_INTEGER;if(n===Dn)return i.RG;if(n===Hl)return i.RG_INTEGER;if(n===Gl)return i.RGBA_INTEGER;if(n===Wo||n===$o||n===Xo||n===qo)if(o===bt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Wo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===$o)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Wo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===$o)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Vl||n===Wl||n===$l||n===Xl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Vl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Wl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===$l)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Xl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ql||n===Yl||n===Zl||n===Kl||n===Jl||n===Yo||n===jl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===ql||n===Yl)return o===bt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Zl)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Kl)return r.COMPRESSED_R11_EAC;if(n===Jl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Yo)return r.COMPRESSED_RG11_EAC;if(n===jl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ql||n===ec||n===tc||n===nc||n===ic||n===sc||n===rc||n===oc||n===ac||n===lc||n===cc||n===hc||n===uc||n===fc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ql)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ec)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===tc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ic)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===rc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===oc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ac)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===lc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===cc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===uc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===fc)return o===bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===dc||n===pc||n===mc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===dc)return o===bt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===pc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===mc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===gc||n===vc||n===Zo||n===_c)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===gc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===vc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Zo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===_c)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===$s?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var EM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Bu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Io(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Ht({vertexShader:EM,fragmentShader:RM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new At(new si(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ku=class extends _i{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,p=null,g=null,y=typeof XRWebGLBinding<"u",m=new Bu,v={},A=t.getContextAttributes(),S=null,w=null,T=[],E=[],x=new it,b=null,L=null,I=new Kt;I.viewport=new wt;let F=new Kt;F.viewport=new wt;let B=[I,F],z=new Nl,D=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ie){let Re=T[ie];return Re===void 0&&(Re=new br,T[ie]=Re),Re.getTargetRaySpace()},this.getControllerGrip=function(ie){let Re=T[ie];return Re===void 0&&(Re=new br,T[ie]=Re),Re.getGripSpace()},this.getHand=function(ie){let Re=T[ie];return Re===void 0&&(Re=new br,T[ie]=Re),Re.getHandSpace()};function q(ie){let Re=E.indexOf(ie.inputSource);if(Re===-1)return;let Ue=T[Re];Ue!==void 0&&(Ue.update(ie.inputSource,ie.frame,c||o),Ue.dispatchEvent({type:ie.type,data:ie.inputSource}))}function K(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",K),s.removeEventListener("inputsourceschange",fe);for(let ie=0;ie<T.length;ie++){let Re=E[ie];Re!==null&&(E[ie]=null,T[ie].disconnect(Re))}D=null,W=null,m.reset();for(let ie in v)delete v[ie];if(e.setRenderTarget(S),p=null,f=null,u=null,s=null,w=null,De.stop(),n.isPresenting=!1,e.setPixelRatio(b),e.setSize(x.width,x.height,!1),L!==null){let ie=L.camera;ie.fov=L.fov,ie.zoom=L.zoom,ie.updateProjectionMatrix(),L=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ie){r=ie,n.isPresenting===!0&&ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ie){a=ie,n.isPresenting===!0&&ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ie){c=ie},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ie){if(s=ie,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",K),s.addEventListener("inputsourceschange",fe),A.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Ue=null,ze=null,me=null;A.depth&&(me=A.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Ue=A.stencil?es:Vi,ze=A.stencil?$s:ri);let $e={colorFormat:t.RGBA8,depthFormat:me,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer($e),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),w=new cn(f.textureWidth,f.textureHeight,{format:yt,type:Nn,depthTexture:new qi(f.textureWidth,f.textureHeight,ze,void 0,void 0,void 0,void 0,void 0,void 0,Ue),stencilBuffer:A.stencil,colorSpace:e.outputColorSpace,samples:A.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let Ue={antialias:A.antialias,alpha:!0,depth:A.depth,stencil:A.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,Ue),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),w=new cn(p.framebufferWidth,p.framebufferHeight,{format:yt,type:Nn,colorSpace:e.outputColorSpace,stencilBuffer:A.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),De.setContext(s),De.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function fe(ie){for(let Re=0;Re<ie.removed.length;Re++){let Ue=ie.removed[Re],ze=E.indexOf(Ue);ze>=0&&(E[ze]=null,T[ze].disconnect(Ue))}for(let Re=0;Re<ie.added.length;Re++){let Ue=ie.added[Re],ze=E.indexOf(Ue);if(ze===-1){for(let $e=0;$e<T.length;$e++)if($e>=E.length){E.push(Ue),ze=$e;break}else if(E[$e]===null){E[$e]=Ue,ze=$e;break}if(ze===-1)break}let me=T[ze];me&&me.connect(Ue)}}function J(ie,Re){Re===null?ie.matrixWorld.copy(ie.matrix):ie.matrixWorld.multiplyMatrices(Re.matrixWorld,ie.matrix),ie.matrixWorldInverse.copy(ie.matrixWorld).invert()}this.updateCamera=function(ie){if(s===null)return;let Re=ie.near,Ue=ie.far;m.texture!==null&&(m.depthNear>0&&(Re=m.depthNear),m.depthFar>0&&(Ue=m.depthFar)),z.near=F.near=I.near=Re,z.far=F.far=I.far=Ue,(D!==z.near||W!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),D=z.near,W=z.far),z.layers.mask=ie.layers.mask|6,I.layers.mask=z.layers.mask&-5,F.layers.mask=z.layers.mask&-3;let ze=ie.parent,me=z.cameras;J(z,ze);for(let $e=0;$e<me.length;$e++)J(me[$e],ze);z.projectionMatrix.copy(I.projectionMatrix),z.projectionMatrixInverse.copy(I.projectionMatrixInverse),L===null&&ie.isPerspectiveCamera&&(L={camera:ie,fov:ie.fov,zoom:ie.zoom}),ae(ie,z,ze)};function ae(ie,Re,Ue){Ue===null?ie.matrix.copy(Re.matrixWorld):(ie.matrix.copy(Ue.matrixWorld),ie.matrix.invert(),ie.matrix.multiply(Re.matrixWorld)),ie.matrix.decompose(ie.position,ie.quaternion,ie.scale),ie.updateMatrixWorld(!0),ie.projectionMatrix.copy(Re.projectionMatrix),ie.projectionMatrixInverse.copy(Re.projectionMatrixInverse),ie.isPerspectiveCamera&&(ie.fov=Ds*2*Math.atan(1/ie.projectionMatrix.elements[5]),ie.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(ie){l=ie,f!==null&&(f.fixedFoveation=ie),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ie)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(ie){return v[ie]};let ce=null;function we(ie,Re){if(h=Re.getViewerPose(c||o),g=Re,h!==null){let Ue=h.views;p!==null&&(e.setRenderTargetFramebuffer(w,p.framebuffer),e.setRenderTarget(w));let ze=!1;Ue.length!==z.cameras.length&&(z.cameras.length=0,ze=!0);for(let Ve=0;Ve<Ue.length;Ve++){let ft=Ue[Ve],mt=null;if(p!==null)mt=p.getViewport(ft);else{let Vt=u.getViewSubImage(f,ft);mt=Vt.viewport,Ve===0&&(e.setRenderTargetTextures(w,Vt.colorTexture,Vt.depthStencilTexture),e.setRenderTarget(w))}let at=B[Ve];at===void 0&&(at=new Kt,at.layers.enable(Ve),at.viewport=new wt,B[Ve]=at),at.matrix.fromArray(ft.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(ft.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(mt.x,mt.y,mt.width,mt.height),Ve===0&&(z.matrix.copy(at.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),ze===!0&&z.cameras.push(at)}let me=s.enabledFeatures;if(me&&me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ve=u.getDepthInformation(Ue[0]);Ve&&Ve.isValid&&Ve.texture&&m.init(Ve,s.renderState)}if(me&&me.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Ve=0;Ve<Ue.length;Ve++){let ft=Ue[Ve].camera;if(ft){let mt=v[ft];mt||(mt=new Io,v[ft]=mt);let at=u.getCameraImage(ft);mt.sourceTexture=at}}}}for(let Ue=0;Ue<T.length;Ue++){let ze=E[Ue],me=T[Ue];ze!==null&&me!==void 0&&me.update(ze,Re,c||o)}ce&&ce(ie,Re),Re.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Re}),g=null}let De=new Em;De.setAnimationLoop(we),this.setAnimationLoop=function(ie){ce=ie},this.dispose=function(){}}},CM=new et,Om=new Je;Om.set(-1,0,0,0,1,0,0,0,1);function IM(i,e){function t(m,v){m.matrixAutoUpdate===!0&&m.updateMatrix(),v.value.copy(m.matrix)}function n(m,v){v.color.getRGB(m.fogColor.value,Tu(i)),v.isFog?(m.fogNear.value=v.near,m.fogFar.value=v.far):v.isFogExp2&&(m.fogDensity.value=v.density)}function s(m,v,A,S,w){v.isNodeMaterial?v.uniformsNeedUpdate=!1:v.isMeshBasicMaterial?r(m,v):v.isMeshLambertMaterial?(r(m,v),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)):v.isMeshToonMaterial?(r(m,v),u(m,v)):v.isMeshPhongMaterial?(r(m,v),h(m,v),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)):v.isMeshStandardMaterial?(r(m,v),f(m,v),v.isMeshPhysicalMaterial&&p(m,v,w)):v.isMeshMatcapMaterial?(r(m,v),g(m,v)):v.isMeshDepthMaterial?r(m,v):v.isMeshDistanceMaterial?(r(m,v),y(m,v)):v.isMeshNormalMaterial?r(m,v):v.isLineBasicMaterial?(o(m,v),v.isLineDashedMaterial&&a(m,v)):v.isPointsMaterial?l(m,v,A,S):v.isSpriteMaterial?c(m,v):v.isShadowMaterial?(m.color.value.copy(v.color),m.opacity.value=v.opacity):v.isShaderMaterial&&(v.uniformsNeedUpdate=!1)}function r(m,v){m.opacity.value=v.opacity,v.color&&m.diffuse.value.copy(v.color),v.emissive&&m.emissive.value.copy(v.emissive).multiplyScalar(v.emissiveIntensity),v.map&&(m.map.value=v.map,t(v.map,m.mapTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.bumpMap&&(m.bumpMap.value=v.bumpMap,t(v.bumpMap,m.bumpMapTransform),m.bumpScale.value=v.bumpScale,v.side===hn&&(m.bumpScale.value*=-1)),v.normalMap&&(m.normalMap.value=v.normalMap,t(v.normalMap,m.normalMapTransform),m.normalScale.value.copy(v.normalScale),v.side===hn&&m.normalScale.value.negate()),v.displacementMap&&(m.displacementMap.value=v.displacementMap,t(v.displacementMap,m.displacementMapTransform),m.displacementScale.value=v.displacementScale,m.displacementBias.value=v.displacementBias),v.emissiveMap&&(m.emissiveMap.value=v.emissiveMap,t(v.emissiveMap,m.emissiveMapTransform)),v.specularMap&&(m.specularMap.value=v.specularMap,t(v.specularMap,m.specularMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest);let A=e.get(v),S=A.envMap,w=A.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(CM.makeRotationFromEuler(w)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Om),m.reflectivity.value=v.reflectivity,m.ior.value=v.ior,m.refractionRatio.value=v.refractionRatio),v.lightMap&&(m.lightMap.value=v.lightMap,m.lightMapIntensity.value=v.lightMapIntensity,t(v.lightMap,m.lightMapTransform)),v.aoMap&&(m.aoMap.value=v.aoMap,m.aoMapIntensity.value=v.aoMapIntensity,t(v.aoMap,m.aoMapTransform))}function o(m,v){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,v.map&&(m.map.value=v.map,t(v.map,m.mapTransform))}function a(m,v){m.dashSize.value=v.dashSize,m.totalSize.value=v.dashSize+v.gapSize,m.scale.value=v.scale}function l(m,v,A,S){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,m.size.value=v.size*A,m.scale.value=S*.5,v.map&&(m.map.value=v.map,t(v.map,m.uvTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest)}function c(m,v){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,m.rotation.value=v.rotation,v.map&&(m.map.value=v.map,t(v.map,m.mapTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest)}function h(m,v){m.specular.value.copy(v.specular),m.shininess.value=Math.max(v.shininess,1e-4)}function u(m,v){v.gradientMap&&(m.gradientMap.value=v.gradientMap)}function f(m,v){m.metalness.value=v.metalness,v.metalnessMap&&(m.metalnessMap.value=v.metalnessMap,t(v.metalnessMap,m.metalnessMapTransform)),m.roughness.value=v.roughness,v.roughnessMap&&(m.roughnessMap.value=v.roughnessMap,t(v.roughnessMap,m.roughnessMapTransform)),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)}function p(m,v,A){m.ior.value=v.ior,v.diffuseRoughness>0&&(m.diffuseRoughness.value=v.diffuseRoughness,v.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=v.diffuseRoughnessMap,t(v.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),v.sheen>0&&(m.sheenColor.value.copy(v.sheenColor).multiplyScalar(v.sheen),m.sheenRoughness.value=v.sheenRoughness,v.sheenColorMap&&(m.sheenColorMap.value=v.sheenColorMap,t(v.sheenColorMap,m.sheenColorMapTransform)),v.sheenRoughnessMap&&(m.sheenRoughnessMap.value=v.sheenRoughnessMap,t(v.sheenRoughnessMap,m.sheenRoughnessMapTransform))),v.clearcoat>0&&(m.clearcoat.value=v.clearcoat,m.clearcoatRoughness.value=v.clearcoatRoughness,v.clearcoatMap&&(m.clearcoatMap.value=v.clearcoatMap,t(v.clearcoatMap,m.clearcoatMapTransform)),v.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=v.clearcoatRoughnessMap,t(v.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),v.clearcoatNormalMap&&(m.clearcoatNormalMap.value=v.clearcoatNormalMap,t(v.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(v.clearcoatNormalScale),v.side===hn&&m.clearcoatNormalScale.value.negate())),v.dispersion>0&&(m.dispersion.value=v.dispersion),v.retroreflectivity>0&&(m.retroreflectivity.value=v.retroreflectivity),v.iridescence>0&&(m.iridescence.value=v.iridescence,m.iridescenceIOR.value=v.iridescenceIOR,m.iridescenceThicknessMinimum.value=v.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=v.iridescenceThicknessMaximum,v.iridescenceMap&&(m.iridescenceMap.value=v.iridescenceMap,t(v.iridescenceMap,m.iridescenceMapTransform)),v.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=v.iridescenceThicknessMap,t(v.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),v.transmission>0&&(m.transmission.value=v.transmission,m.transmissionSamplerMap.value=A.texture,m.transmissionSamplerSize.value.set(A.width,A.height),v.transmissionMap&&(m.transmissionMap.value=v.transmissionMap,t(v.transmissionMap,m.transmissionMapTransform)),m.thickness.value=v.thickness,v.thicknessMap&&(m.thicknessMap.value=v.thicknessMap,t(v.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=v.attenuationDistance,m.attenuationColor.value.copy(v.attenuationColor)),v.anisotropy>0&&(m.anisotropyVector.value.set(v.anisotropy*Math.cos(v.anisotropyRotation),v.anisotropy*Math.sin(v.anisotropyRotation)),v.anisotropyMap&&(m.anisotropyMap.value=v.anisotropyMap,t(v.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=v.specularIntensity,m.specularColor.value.copy(v.specularColor),v.specularColorMap&&(m.specularColorMap.value=v.specularColorMap,t(v.specularColorMap,m.specularColorMapTransform)),v.specularIntensityMap&&(m.specularIntensityMap.value=v.specularIntensityMap,t(v.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,v){v.matcap&&(m.matcap.value=v.matcap)}function y(m,v){let A=e.get(v).light;m.referencePosition.value.setFromMatrixPosition(A.matrixWorld),m.nearDistance.value=A.shadow.camera.near,m.farDistance.value=A.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function PM(i,e,t,n){let s={},r={};function o(A,S){let w=S.program;n.uniformBlockBinding(A,w,s[A.id])}function a(A,S){let w=s[A.id];w===void 0&&(g(A),w=l(A),s[A.id]=w,A.addEventListener("dispose",m));let T=S.program;n.updateUBOMapping(A,T);let E=e.render.frame;r[A.id]!==E&&(c(A),r[A.id]=E)}function l(A){let S=i.createBuffer(),w=A.__size,T=A.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,w,T),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function c(A){let S=s[A.id],w=A.uniforms,T=A.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let E=0,x=w.length;E<x;E++){let b=w[E];if(Array.isArray(b))for(let L=0,I=b.length;L<I;L++)h(b[L],E,L,T);else h(b,E,0,T)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(A,S,w,T){if(f(A,S,w,T)===!0){let E=A.__offset,x=A.value;if(Array.isArray(x)){let b=0;for(let L=0;L<x.length;L++){let I=x[L],F=y(I,!0);u(I,A.__data,b),b+=F.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,A.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,A.__data)}}function u(A,S,w){typeof A=="number"||typeof A=="boolean"?S[w]=A:A.isMatrix3?(S[w]=A.elements[0],S[w+1]=A.elements[1],S[w+2]=A.elements[2],S[w+3]=0,S[w+4]=A.elements[3],S[w+5]=A.elements[4],S[w+6]=A.elements[5],S[w+7]=0,S[w+8]=A.elements[6],S[w+9]=A.elements[7],S[w+10]=A.elements[8],S[w+11]=0):ArrayBuffer.isView(A)?S.set(A.subarray(0,S.length-w),w):A.toArray(S,w)}function f(A,S,w,T){let E=A.value,x=S+"_"+w;if(Array.isArray(E)){T[x]===void 0&&(T[x]=[]);let b=T[x],L=!1;for(let I=0;I<E.length;I++)p(E[I],b,I)===!0&&(L=!0);return L}return p(E,T,x)}function p(A,S,w){if(S[w]===void 0)return typeof A=="number"||typeof A=="boolean"?S[w]=A:ArrayBuffer.isView(A)?S[w]=A.slice():S[w]=A.clone(),!0;{let T=S[w];if(typeof A=="number"||typeof A=="boolean"){if(T!==A)return S[w]=A,!0}else{if(ArrayBuffer.isView(A))return!0;if(T.equals(A)===!1)return T.copy(A),!0}}return!1}function g(A){let S=A.uniforms,w=0,T=16;for(let x=0,b=S.length;x<b;x++){let L=Array.isArray(S[x])?S[x]:[S[x]];for(let I=0,F=L.length;I<F;I++){let B=L[I],z=Array.isArray(B.value)?B.value:[B.value],D=Array.isArray(S[x])||Array.isArray(B.value),W=w;for(let K=0,fe=z.length;K<fe;K++){let J=z[K],ae=y(J,D),ce=w%T,we=ce%ae.boundary,De=ce+we;w+=we,De!==0&&T-De<ae.storage&&(w+=T-De),K===0&&(W=w),w+=ae.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((w-W)/Float32Array.BYTES_PER_ELEMENT),B.__offset=W}}let E=w%T;return E>0&&(w+=T-E),A.__size=w,A.__cache={},this}function y(A,S){let w={boundary:0,storage:0};return typeof A=="number"||typeof A=="boolean"?(w.boundary=4,w.storage=4):A.isVector2?(w.boundary=8,w.storage=8):A.isVector3||A.isColor?(w.boundary=16,w.storage=12):A.isVector4?(w.boundary=16,w.storage=16):A.isMatrix3?(w.boundary=16,w.storage=48):A.isMatrix4?(w.boundary=16,w.storage=64):A.isTexture?ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(A)?(w.boundary=16,w.storage=A.byteLength):ke("WebGLRenderer: Unsupported uniform value type.",A),S===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function m(A){let S=A.target;S.removeEventListener("dispose",m),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function v(){for(let A in s)i.deleteBuffer(s[A]);s={},r={}}return{bind:o,update:a,dispose:v}}var LM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Si=null;function NM(){return Si===null&&(Si=new mn(LM,16,16,Dn,Jt),Si.name="DFG_LUT",Si.minFilter=Et,Si.magFilter=Et,Si.wrapS=Rn,Si.wrapT=Rn,Si.generateMipmaps=!1,Si.needsUpdate=!0),Si}var Ac=class{constructor(e={}){let{canvas:t=jp(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:p=Nn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=p,m=new Set([Gl,Hl,zl]),v=new Set([Nn,ri,Fr,$s,Bl,kl]),A=new Uint32Array(4),S=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},T=null,E=null,x=[],b=[],L=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=bi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,F=!1,B=null,z=null,D=null,W=null;this._outputColorSpace=Xt;let q=0,K=0,fe=null,J=-1,ae=null,ce=new wt,we=new wt,De=null,ie=new Xe(0),Re=0,Ue=t.width,ze=t.height,me=1,$e=null,Mt=null,Ve=new wt(0,0,Ue,ze),ft=new wt(0,0,Ue,ze),mt=!1,at=new ys,Vt=new _l,Bt=!1,sn=!1,Dt=new et,Wn=new $,qt=new wt,vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_n=!1;function An(){return fe===null?me:1}let V=n;function yn(d,M){return t.getContext(d,M)}let Rt,Ct,Ce,Yt,Ge,je,O,R,Z,ge,le,be,Ie,te,se,Me,k,ne,j,Ae,ve,Se,Be;try{let d={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",He,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Le,!1),V===null){let M="webgl2";if(V=yn(M,d),V===null)throw yn(M)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(d){throw t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Le,!1),Ke("WebGLRenderer: "+d.message),d}function tt(){Rt=new Wx(V),Rt.init(),ve=new TM(V,Rt),Ct=new Nx(V,Rt,e,ve),Ce=new wM(V,Rt),Ct.reversedDepthBuffer&&f&&Ce.buffers.depth.setReversed(!0),z=V.createFramebuffer(),D=V.createFramebuffer(),W=V.createFramebuffer(),Yt=new qx(V),Ge=new hM,je=new AM(V,Rt,Ce,Ge,Ct,ve,Yt),O=new Vx(I),R=new Zv(V),Se=new Px(V,R),Z=new $x(V,R,Yt,Se),ge=new Zx(V,Z,R,Se,Yt),ne=new Yx(V,Ct,je),se=new Dx(Ge),le=new cM(I,O,Rt,Ct,Se,se),be=new IM(I,Ge),Ie=new fM,te=new _M(Rt),k=new Ix(I,O,Ce,ge,g,l),Me=new SM(I,ge,Ct),Be=new PM(V,Yt,Ct,Ce),j=new Lx(V,Rt,Yt),Ae=new Xx(V,Rt,Yt),Yt.programs=le.programs,I.capabilities=Ct,I.extensions=Rt,I.properties=Ge,I.renderLists=Ie,I.shadowMap=Me,I.state=Ce,I.info=Yt}y!==Nn&&(L=new Jx(y,t.width,t.height,a,s,r));let _e=new ku(I,V);this.xr=_e,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let d=Rt.get("WEBGL_lose_context");d&&d.loseContext()},this.forceContextRestore=function(){let d=Rt.get("WEBGL_lose_context");d&&d.restoreContext()},this.getPixelRatio=function(){return me},this.setPixelRatio=function(d){d!==void 0&&(me=d,this.setSize(Ue,ze,!1))},this.getSize=function(d){return d.set(Ue,ze)},this.setSize=function(d,M,C=!0){if(_e.isPresenting){ke("WebGLRenderer: Can't change size while VR device is presenting.");return}Ue=d,ze=M,t.width=Math.floor(d*me),t.height=Math.floor(M*me),C===!0&&(t.style.width=d+"px",t.style.height=M+"px"),L!==null&&L.setSize(t.width,t.height),this.setViewport(0,0,d,M)},this.getDrawingBufferSize=function(d){return d.set(Ue*me,ze*me).floor()},this.setDrawingBufferSize=function(d,M,C){Ue=d,ze=M,me=C,t.width=Math.floor(d*C),t.height=Math.floor(M*C),this.setViewport(0,0,d,M)},this.setEffects=function(d){if(y===Nn){Ke("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(d){for(let M=0;M<d.length;M++)if(d[M].isOutputPass===!0){ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(d||[])},this.getCurrentViewport=function(d){return d.copy(ce)},this.getViewport=function(d){return d.copy(Ve)},this.setViewport=function(d,M,C,P){d.isVector4?Ve.set(d.x,d.y,d.z,d.w):Ve.set(d,M,C,P),Ce.viewport(ce.copy(Ve).multiplyScalar(An()).round())},this.getScissor=function(d){return d.copy(ft)},this.setScissor=function(d,M,C,P){d.isVector4?ft.set(d.x,d.y,d.z,d.w):ft.set(d,M,C,P),Ce.scissor(we.copy(ft).multiplyScalar(An()).round())},this.getScissorTest=function(){return mt},this.setScissorTest=function(d){Ce.setScissorTest(mt=d)},this.setOpaqueSort=function(d){$e=d},this.setTransparentSort=function(d){Mt=d},this.getClearColor=function(d){return d.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(d=!0,M=!0,C=!0){let P=0;if(d){let U=!1;if(fe!==null){let N=fe.texture.format;U=m.has(N)}if(U){let N=fe.texture.type,X=v.has(N),H=k.getClearColor(),G=k.getClearAlpha(),Y=H.r,re=H.g,Q=H.b;X?(A[0]=Y,A[1]=re,A[2]=Q,A[3]=G,V.clearBufferuiv(V.COLOR,0,A)):(S[0]=Y,S[1]=re,S[2]=Q,S[3]=G,V.clearBufferiv(V.COLOR,0,S))}else P|=V.COLOR_BUFFER_BIT}M&&(P|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),C&&(P|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),P!==0&&V.clear(P)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(d){d.setRenderer(this),B=d},this.dispose=function(){t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Le,!1),k.dispose(),Ie.dispose(),te.dispose(),je.dispose(),Ge.dispose(),O.dispose(),ge.dispose(),Z.dispose(),Se.dispose(),Be.dispose(),le.dispose(),_e.dispose(),_e.removeEventListener("sessionstart",Xr),_e.removeEventListener("sessionend",la),Ci.stop()};function He(d){d.preventDefault(),go("WebGLRenderer: Context Lost."),F=!0}function Qe(){go("WebGLRenderer: Context Restored."),F=!1;let d=Yt.autoReset,M=Me.enabled,C=Me.autoUpdate,P=Me.needsUpdate,U=Me.type;tt(),Yt.autoReset=d,Me.enabled=M,Me.autoUpdate=C,Me.needsUpdate=P,Me.type=U}function Le(d){Ke("WebGLRenderer: A WebGL context could not be created. Reason: ",d.statusMessage)}function vt(d){let M=d.target;M.removeEventListener("dispose",vt),jt(M)}function jt(d){ci(d),Ge.remove(d)}function ci(d){let M=Ge.get(d).programs;M!==void 0&&(M.forEach(function(C){le.releaseProgram(C)}),d.isShaderMaterial&&le.releaseShaderCache(d))}this.renderBufferDirect=function(d,M,C,P,U,N){M===null&&(M=vn);let X=U.isMesh&&U.matrixWorld.determinantAffine()<0,H=da(d,M,C,P,U);Ce.setMaterial(P,X);let G=C.index,Y=1;if(P.wireframe===!0){if(G=Z.getWireframeAttribute(C),G===void 0)return;Y=2}let re=C.drawRange,Q=C.attributes.position,ee=re.start*Y,ue=(re.start+re.count)*Y;N!==null&&(ee=Math.max(ee,N.start*Y),ue=Math.min(ue,(N.start+N.count)*Y)),G!==null?(ee=Math.max(ee,0),ue=Math.min(ue,G.count)):Q!=null&&(ee=Math.max(ee,0),ue=Math.min(ue,Q.count));let de=ue-ee;if(de<0||de===1/0)return;Se.setup(U,P,H,C,G);let pe,Te=j;if(G!==null&&(pe=R.get(G),Te=Ae,Te.setIndex(pe)),U.isMesh)P.wireframe===!0?(Ce.setLineWidth(P.wireframeLinewidth*An()),Te.setMode(V.LINES)):Te.setMode(V.TRIANGLES);else if(U.isLine){let We=P.linewidth;We===void 0&&(We=1),Ce.setLineWidth(We*An()),U.isLineSegments?Te.setMode(V.LINES):U.isLineLoop?Te.setMode(V.LINE_LOOP):Te.setMode(V.LINE_STRIP)}else U.isPoints?Te.setMode(V.POINTS):U.isSprite&&Te.setMode(V.TRIANGLES);if(U.isBatchedMesh)if(Rt.get("WEBGL_multi_draw"))Te.renderMultiDraw(U._multiDrawStarts,U._multiDrawCounts,U._multiDrawCount);else{let We=U._multiDrawStarts,he=U._multiDrawCounts,Ye=U._multiDrawCount,ye=G?R.get(G).bytesPerElement:1,Pe=Ge.get(P).currentProgram.getUniforms();for(let Ne=0;Ne<Ye;Ne++)Pe.setValue(V,"_gl_DrawID",Ne),Te.render(We[Ne]/ye,he[Ne])}else if(U.isInstancedMesh)Te.renderInstances(ee,de,U.count);else if(C.isInstancedBufferGeometry){let We=C._maxInstanceCount!==void 0?C._maxInstanceCount:1/0,he=Math.min(C.instanceCount,We);Te.renderInstances(ee,de,he)}else Te.render(ee,de)};function aa(d,M,C,P){B!==null&&d.isNodeMaterial&&B.setObject(P,d),Bt===!0&&se.setState(d,C,!1),d.transparent===!0&&d.side===Ln&&d.forceSinglePass===!1?(d.side=hn,d.needsUpdate=!0,hi(d,M,P),d.side=Zn,d.needsUpdate=!0,hi(d,M,P),d.side=Ln):hi(d,M,P)}this.compile=function(d,M,C=null){C===null&&(C=d),B!==null&&B.renderStart(d,M,C),E=te.get(C),E.init(M),b.push(E),C.traverseVisible(function(U){U.isLight&&U.layers.test(M.layers)&&(E.pushLight(U),U.castShadow&&E.pushShadow(U))}),d!==C&&d.traverseVisible(function(U){U.isLight&&U.layers.test(M.layers)&&(E.pushLight(U),U.castShadow&&E.pushShadow(U))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),sn=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,sn),Bt===!0&&se.setGlobalState(this.clippingPlanes,M),B!==null&&Me.render(E.state.shadowsArray,C,M);let P=new Set;return d.traverse(function(U){if(!(U.isMesh||U.isPoints||U.isLine||U.isSprite))return;let N=U.material;if(N)if(Array.isArray(N))for(let X=0;X<N.length;X++){let H=N[X];aa(H,C,M,U),P.add(H)}else aa(N,C,M,U),P.add(N)}),E=b.pop(),B!==null&&B.renderEnd(),P},this.compileAsync=function(d,M,C=null){let P=this.compile(d,M,C);return new Promise(U=>{function N(){if(P.forEach(function(X){let G=Ge.get(X).currentProgram;(G===void 0||G.isReady())&&P.delete(X)}),P.size===0){U(d);return}setTimeout(N,10)}Rt.get("KHR_parallel_shader_compile")!==null?N():setTimeout(N,10)})};let $r=null;function jc(d){$r&&$r(d)}function Xr(){Ci.stop()}function la(){Ci.start()}let Ci=new Em;Ci.setAnimationLoop(jc),typeof self<"u"&&Ci.setContext(self),this.setAnimationLoop=function(d){$r=d,_e.setAnimationLoop(d),d===null?Ci.stop():Ci.start()},_e.addEventListener("sessionstart",Xr),_e.addEventListener("sessionend",la),this.render=function(d,M){if(M!==void 0&&M.isCamera!==!0){Ke("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;B!==null&&B.renderStart(d,M);let C=_e.enabled===!0&&_e.isPresenting===!0,P=L!==null&&(fe===null||C)&&L.begin(I,fe);if(d.matrixWorldAutoUpdate===!0&&d.updateMatrixWorld(),M.parent===null&&M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),_e.enabled===!0&&_e.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(_e.cameraAutoUpdate===!0&&_e.updateCamera(M),M=_e.getCamera()),d.isScene===!0&&d.onBeforeRender(I,d,M,fe),E=te.get(d,b.length),E.init(M),E.state.textureUnits=je.getTextureUnits(),b.push(E),Dt.multiplyMatrices(M.projectionMatrix,M.matrixWorldInverse),M.isArrayCamera?Vt.setFromArrayCamera(M):at.setFromProjectionMatrix(Dt,qn,M.reversedDepth),sn=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,sn),T=Ie.get(d,x.length),T.init(),x.push(T),this.info.render.frame++,_e.enabled===!0&&_e.isPresenting===!0){let X=I.xr.getDepthSensingMesh();X!==null&&qr(X,M,-1/0,I.sortObjects)}qr(d,M,0,I.sortObjects),T.finish(),B!==null&&B.updateLights(E.state.lightsArray),I.sortObjects===!0&&T.sort($e,Mt),_n=_e.enabled===!1||_e.isPresenting===!1||_e.hasDepthSensing()===!1,_n&&k.addToRenderList(T,d),this.info.autoReset===!0&&this.info.reset(),Bt===!0&&se.beginShadows();let U=E.state.shadowsArray;if(Me.render(U,d,M),Bt===!0&&se.endShadows(),(P&&L.hasRenderPass())===!1){let X=T.opaque,H=T.transmissive;if(E.setupLights(),M.isArrayCamera){let G=M.cameras;if(H.length>0)for(let Y=0,re=G.length;Y<re;Y++){let Q=G[Y];ca(X,H,d,Q)}_n&&k.render(d);for(let Y=0,re=G.length;Y<re;Y++){let Q=G[Y];Yr(T,d,Q,Q.viewport)}}else H.length>0&&ca(X,H,d,M),_n&&k.render(d),Yr(T,d,M)}fe!==null&&K===0&&(je.updateMultisampleRenderTarget(fe),je.updateRenderTargetMipmap(fe)),P&&L.end(I),d.isScene===!0&&d.onAfterRender(I,d,M),Se.resetDefaultState(),J=-1,ae=null,b.pop(),b.length>0?(E=b[b.length-1],je.setTextureUnits(E.state.textureUnits),Bt===!0&&se.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?T=x[x.length-1]:T=null,B!==null&&B.renderEnd()};function qr(d,M,C,P){if(d.visible===!1)return;if(d.layers.test(M.layers)){if(d.isGroup)C=d.renderOrder;else if(d.isLOD)d.autoUpdate===!0&&d.update(M);else if(d.isLight)E.pushLight(d),d.castShadow&&E.pushShadow(d);else if(d.isSprite){let X=M.isArrayCamera?Vt:at;if(!d.frustumCulled||d.intersectsFrustum(X)){P&&qt.setFromMatrixPosition(d.matrixWorld).applyMatrix4(Dt);let H=ge.update(d),G=d.material;G.visible&&T.push(d,H,G,C,qt.z,null,M)}}else if(d.isMesh||d.isLine||d.isPoints){let X=M.isArrayCamera?Vt:at;if(!d.frustumCulled||d.intersectsFrustum(X)){let H=ge.update(d),G=d.material;if(P&&(d.boundingSphere!==void 0?(d.boundingSphere===null&&d.computeBoundingSphere(),qt.copy(d.boundingSphere.center)):(H.boundingSphere===null&&H.computeBoundingSphere(),qt.copy(H.boundingSphere.center)),qt.applyMatrix4(d.matrixWorld).applyMatrix4(Dt)),Array.isArray(G)){let Y=H.groups;for(let re=0,Q=Y.length;re<Q;re++){let ee=Y[re],ue=G[ee.materialIndex];ue&&ue.visible&&T.push(d,H,ue,C,qt.z,ee,M)}}else G.visible&&T.push(d,H,G,C,qt.z,null,M)}}}let N=d.children;for(let X=0,H=N.length;X<H;X++)qr(N[X],M,C,P)}function Yr(d,M,C,P){let{opaque:U,transmissive:N,transparent:X}=d;E.setupLightsView(C),Bt===!0&&se.setGlobalState(I.clippingPlanes,C),P&&Ce.viewport(ce.copy(P)),U.length>0&&Ms(U,M,C),N.length>0&&Ms(N,M,C),X.length>0&&Ms(X,M,C),Ce.buffers.depth.setTest(!0),Ce.buffers.depth.setMask(!0),Ce.buffers.color.setMask(!0),Ce.setPolygonOffset(!1)}function ca(d,M,C,P){if((C.isScene===!0?C.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[P.id]===void 0){let ee=Rt.has("EXT_color_buffer_half_float")||Rt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[P.id]=new cn(1,1,{generateMipmaps:!0,type:ee?Jt:Nn,minFilter:Vn,samples:Math.max(4,Ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:rt.workingColorSpace})}let N=E.state.transmissionRenderTarget[P.id],X=P.viewport||ce;N.setSize(X.z*I.transmissionResolutionScale,X.w*I.transmissionResolutionScale);let H=I.getRenderTarget(),G=I.getActiveCubeFace(),Y=I.getActiveMipmapLevel();I.setRenderTarget(N),I.getClearColor(ie),Re=I.getClearAlpha(),Re<1&&I.setClearColor(16777215,.5),I.clear(),_n&&k.render(C);let re=I.toneMapping;I.toneMapping=bi;let Q=P.viewport;if(P.viewport!==void 0&&(P.viewport=void 0),E.setupLightsView(P),Bt===!0&&se.setGlobalState(I.clippingPlanes,P),Ms(d,C,P),je.updateMultisampleRenderTarget(N),je.updateRenderTargetMipmap(N),Rt.has("WEBGL_multisampled_render_to_texture")===!1){let ee=!1;for(let ue=0,de=M.length;ue<de;ue++){let pe=M[ue],{object:Te,geometry:We,material:he,group:Ye}=pe;if(he.side===Ln&&Te.layers.test(P.layers)){let ye=he.side;he.side=hn,he.needsUpdate=!0,ha(Te,C,P,We,he,Ye),he.side=ye,he.needsUpdate=!0,ee=!0}}ee===!0&&(je.updateMultisampleRenderTarget(N),je.updateRenderTargetMipmap(N))}I.setRenderTarget(H,G,Y),I.setClearColor(ie,Re),Q!==void 0&&(P.viewport=Q),I.toneMapping=re}function Ms(d,M,C){let P=M.isScene===!0?M.overrideMaterial:null;for(let U=0,N=d.length;U<N;U++){let X=d[U],{object:H,geometry:G,group:Y}=X,re=X.material;re.allowOverride===!0&&P!==null&&(re=P),H.layers.test(C.layers)&&ha(H,M,C,G,re,Y)}}function ha(d,M,C,P,U,N){B!==null&&U.isNodeMaterial&&B.setObject(d,U),d.onBeforeRender(I,M,C,P,U,N),d.modelViewMatrix.multiplyMatrices(C.matrixWorldInverse,d.matrixWorld),d.normalMatrix.getNormalMatrix(d.modelViewMatrix),U.onBeforeRender(I,M,C,P,d,N),U.transparent===!0&&U.side===Ln&&U.forceSinglePass===!1?(U.side=hn,U.needsUpdate=!0,I.renderBufferDirect(C,M,P,U,d,N),U.side=Zn,U.needsUpdate=!0,I.renderBufferDirect(C,M,P,U,d,N),U.side=Ln):I.renderBufferDirect(C,M,P,U,d,N),d.onAfterRender(I,M,C,P,U,N)}function ua(d){let M=0;for(let C of d)C.texture!==null&&M++;return M}function hi(d,M,C){M.isScene!==!0&&(M=vn);let P=Ge.get(d),U=E.state.lights,N=E.state.shadowsArray,X=U.state.version,H=le.getParameters(d,U.state,N,M,C,E.state.lightProbeGridArray),G=le.getProgramCacheKey(H),Y=P.programs;P.environment=d.isMeshStandardMaterial||d.isMeshLambertMaterial||d.isMeshPhongMaterial?M.environment:null,P.fog=M.fog;let re=d.isMeshStandardMaterial||d.isMeshLambertMaterial&&!d.envMap||d.isMeshPhongMaterial&&!d.envMap;P.envMap=O.get(d.envMap||P.environment,re),P.envMapRotation=P.environment!==null&&d.envMap===null?M.environmentRotation:d.envMapRotation,Y===void 0&&(d.addEventListener("dispose",vt),Y=new Map,P.programs=Y,P.programVariants=new Map);let Q=Y.get(G);if(Q!==void 0){if(P.currentProgram===Q&&P.lightsStateVersion===X)return Ss(d,H),Q}else H.uniforms=le.getUniforms(d),B!==null&&d.isNodeMaterial&&B.build(d,C,H),d.onBeforeCompile(H,I),Q=le.acquireProgram(H,G),Y.set(G,Q),P.uniforms=H.uniforms;let ee=P.uniforms;return(!d.isShaderMaterial&&!d.isRawShaderMaterial||d.clipping===!0)&&(ee.clippingPlanes=se.uniform),Ss(d,H),P.needsLights=Tn(d),P.lightsStateVersion=X,P.needsLights&&(ee.ambientLightColor.value=U.state.ambient,ee.lightProbe.value=U.state.probe,ee.sunLights.value=U.state.sun,ee.sunLightShadows.value=U.state.sunShadow,ee.directionalLights.value=U.state.directional,ee.directionalLightShadows.value=U.state.directionalShadow,ee.spotLights.value=U.state.spot,ee.spotLightShadows.value=U.state.spotShadow,ee.rectAreaLights.value=U.state.rectArea,ee.ltc_1.value=U.state.rectAreaLTC1,ee.ltc_2.value=U.state.rectAreaLTC2,ee.pointLights.value=U.state.point,ee.pointLightShadows.value=U.state.pointShadow,ee.hemisphereLights.value=U.state.hemi,ee.sunShadowMatrix.value=U.state.sunShadowMatrix,ee.sunShadowCascade.value=U.state.sunShadowCascade,ee.directionalShadowMatrix.value=U.state.directionalShadowMatrix,ee.spotLightMatrix.value=U.state.spotLightMatrix,ee.spotLightMap.value=U.state.spotLightMap,ee.pointShadowMatrix.value=U.state.pointShadowMatrix),P.numLightProbeGrids=ua(E.state.lightProbeGridArray),P.currentProgram=Q,P.uniformsList=null,Q}function Ks(d,M,C,P,U){let N=Ge.get(d),X=N.currentProgram.id+","+P+","+U,H=N.programVariants.get(X);return H===void 0?(H=hi(d,M,C),N.programVariants.set(X,H)):(N.currentProgram=H,N.uniformsList=null,N.outputColorSpace=P,N.toneMapping=U),H}function fa(d){if(d.uniformsList===null){let M=d.currentProgram.getUniforms();d.uniformsList=Or.seqWithValue(M.seq,d.uniforms)}return d.uniformsList}function Ss(d,M){let C=Ge.get(d);C.outputColorSpace=M.outputColorSpace,C.batching=M.batching,C.batchingColor=M.batchingColor,C.instancing=M.instancing,C.instancingColor=M.instancingColor,C.instancingMorph=M.instancingMorph,C.skinning=M.skinning,C.morphTargets=M.morphTargets,C.morphNormals=M.morphNormals,C.morphColors=M.morphColors,C.morphTargetsCount=M.morphTargetsCount,C.numClippingPlanes=M.numClippingPlanes,C.numIntersection=M.numClipIntersection,C.vertexAlphas=M.vertexAlphas,C.vertexTangents=M.vertexTangents,C.toneMapping=M.toneMapping}function da(d,M,C,P,U){M.isScene!==!0&&(M=vn),je.resetTextureUnits();let N=M.fog,X=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?M.environment:null,H=fe===null?I.outputColorSpace:fe.isXRRenderTarget===!0?fe.texture.colorSpace:rt.workingColorSpace,G=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap,Y=O.get(P.envMap||X,G),re=P.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,Q=!!C.attributes.tangent&&(!!P.normalMap||P.anisotropy>0),ee=!!C.morphAttributes.position,ue=!!C.morphAttributes.normal,de=!!C.morphAttributes.color,pe=bi;P.toneMapped&&(fe===null||fe.isXRRenderTarget===!0)&&(pe=I.toneMapping);let Te=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,We=Te!==void 0?Te.length:0,he=Ge.get(P),Ye=E.state.lights;if(Bt===!0&&(sn===!0||d!==ae)){let Ze=d===ae&&P.id===J;se.setState(P,d,Ze)}let ye=!1,Pe=!1;P.version===he.__version?he.needsLights&&he.lightsStateVersion!==Ye.state.version||U.isBatchedMesh&&he.batching===!1||!U.isBatchedMesh&&he.batching===!0||U.isBatchedMesh&&he.batchingColor===!0&&U._colorsTexture===null||U.isBatchedMesh&&he.batchingColor===!1&&U._colorsTexture!==null||U.isInstancedMesh&&he.instancing===!1||!U.isInstancedMesh&&he.instancing===!0||U.isSkinnedMesh&&he.skinning===!1||!U.isSkinnedMesh&&he.skinning===!0||U.isInstancedMesh&&he.instancingColor===!0&&U.instanceColor===null||U.isInstancedMesh&&he.instancingColor===!1&&U.instanceColor!==null||U.isInstancedMesh&&he.instancingMorph===!0&&U.morphTexture===null||U.isInstancedMesh&&he.instancingMorph===!1&&U.morphTexture!==null||he.envMap!==Y||P.fog===!0&&he.fog!==N||he.numClippingPlanes!==void 0&&(he.numClippingPlanes!==se.numPlanes||he.numIntersection!==se.numIntersection)||he.vertexAlphas!==re||he.vertexTangents!==Q||he.morphTargets!==ee||he.morphNormals!==ue||he.morphColors!==de||he.morphTargetsCount!==We||he.numLightProbeGrids!==ua(E.state.lightProbeGridArray)?ye=!0:(he.outputColorSpace!==H||he.toneMapping!==pe)&&(Pe=!0):(ye=!0,he.__version=P.version);let Ne=he.currentProgram;(ye===!0||Pe===!0)&&(Ne=Pe===!0?Ks(P,M,U,H,pe):hi(P,M,U),B&&P.isNodeMaterial&&B.onUpdateProgram(P,Ne,he));let gt=!1,nt=!1,qe=!1,Oe=Ne.getUniforms(),lt=he.uniforms;if(Ce.useProgram(Ne.program)&&(gt=!0,nt=!0,qe=!0),P.id!==J&&(J=P.id,nt=!0),gt||ae!==d){Ce.buffers.depth.getReversed()&&d.reversedDepth!==!0&&(d._reversedDepth=!0,d.updateProjectionMatrix()),Oe.setValue(V,"projectionMatrix",d.projectionMatrix),Oe.setValue(V,"viewMatrix",d.matrixWorldInverse);let St=Oe.map.cameraPosition;St!==void 0&&St.setValue(V,Wn.setFromMatrixPosition(d.matrixWorld)),Ct.logarithmicDepthBuffer&&Oe.setValue(V,"logDepthBufFC",2/(Math.log(d.far+1)/Math.LN2)),(P.isMeshPhongMaterial||P.isMeshToonMaterial||P.isMeshLambertMaterial||P.isMeshBasicMaterial||P.isMeshStandardMaterial||P.isShaderMaterial)&&Oe.setValue(V,"isOrthographic",d.isOrthographicCamera===!0),ae!==d&&(ae=d,nt=!0,qe=!0)}if(he.needsLights&&(Ye.state.sunShadowMap.length>0&&Oe.setValue(V,"sunShadowMap",Ye.state.sunShadowMap,je),Ye.state.directionalShadowMap.length>0&&Oe.setValue(V,"directionalShadowMap",Ye.state.directionalShadowMap,je),Ye.state.spotShadowMap.length>0&&Oe.setValue(V,"spotShadowMap",Ye.state.spotShadowMap,je),Ye.state.pointShadowMap.length>0&&Oe.setValue(V,"pointShadowMap",Ye.state.pointShadowMap,je)),U.isSkinnedMesh){Oe.setOptional(V,U,"bindMatrix"),Oe.setOptional(V,U,"bindMatrixInverse");let Ze=U.skeleton;Ze&&(Ze.boneTexture===null&&Ze.computeBoneTexture(),Oe.setValue(V,"boneTexture",Ze.boneTexture,je))}U.isBatchedMesh&&(Oe.setOptional(V,U,"batchingTexture"),Oe.setValue(V,"batchingTexture",U._matricesTexture,je),Oe.setOptional(V,U,"batchingIdTexture"),Oe.setValue(V,"batchingIdTexture",U._indirectTexture,je),Oe.setOptional(V,U,"batchingColorTexture"),U._colorsTexture!==null&&Oe.setValue(V,"batchingColorTexture",U._colorsTexture,je));let Ft=C.morphAttributes;if((Ft.position!==void 0||Ft.normal!==void 0||Ft.color!==void 0)&&ne.update(U,C,Ne),(nt||he.receiveShadow!==U.receiveShadow)&&(he.receiveShadow=U.receiveShadow,Oe.setValue(V,"receiveShadow",U.receiveShadow)),(P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial)&&P.envMap===null&&M.environment!==null&&(lt.envMapIntensity.value=M.environmentIntensity),lt.dfgLUT!==void 0&&(lt.dfgLUT.value=NM()),nt){if(Oe.setValue(V,"toneMappingExposure",I.toneMappingExposure),he.needsLights&&rn(lt,qe),N&&P.fog===!0&&be.refreshFogUniforms(lt,N),be.refreshMaterialUniforms(lt,P,me,ze,E.state.transmissionRenderTarget[d.id]),he.needsLights&&he.numLightProbeGrids>0){let Ze=w,St=0;for(let un of E.state.lightProbeGridArray)un.texture!==null&&(Ze.textures[St]=un.texture,Ze.min[St]=un.boundingBox.min,Ze.max[St]=un.boundingBox.max,Ze.resolution[St]=un.resolution,St++);for(let un in Ze)Ze[un].length=St;lt.probesSH.value=Ze.textures,lt.probesMin.value=Ze.min,lt.probesMax.value=Ze.max,lt.probesResolution.value=Ze.resolution}Or.upload(V,fa(he),lt,je)}if(P.isShaderMaterial&&P.uniformsNeedUpdate===!0&&(Or.upload(V,fa(he),lt,je),P.uniformsNeedUpdate=!1),P.isSpriteMaterial&&Oe.setValue(V,"center",U.center),Oe.setValue(V,"modelViewMatrix",U.modelViewMatrix),Oe.setValue(V,"normalMatrix",U.normalMatrix),Oe.setValue(V,"modelMatrix",U.matrixWorld),P.uniformsGroups!==void 0){let Ze=P.uniformsGroups;for(let St=0,un=Ze.length;St<un;St++){let os=Ze[St];Be.update(os,Ne),Be.bind(os,Ne)}}return Ne}function rn(d,M){d.ambientLightColor.needsUpdate=M,d.lightProbe.needsUpdate=M,d.sunLights.needsUpdate=M,d.sunLightShadows.needsUpdate=M,d.directionalLights.needsUpdate=M,d.directionalLightShadows.needsUpdate=M,d.pointLights.needsUpdate=M,d.pointLightShadows.needsUpdate=M,d.spotLights.needsUpdate=M,d.spotLightShadows.needsUpdate=M,d.rectAreaLights.needsUpdate=M,d.hemisphereLights.needsUpdate=M}function Tn(d){return d.isMeshLambertMaterial||d.isMeshToonMaterial||d.isMeshPhongMaterial||d.isMeshStandardMaterial||d.isShadowMaterial||d.isShaderMaterial&&d.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return K},this.getRenderTarget=function(){return fe},this.setRenderTargetTextures=function(d,M,C){let P=Ge.get(d);P.__autoAllocateDepthBuffer=d.resolveDepthBuffer===!1,P.__autoAllocateDepthBuffer===!1&&(P.__useRenderToTexture=!1),Ge.get(d.texture).__webglTexture=M,Ge.get(d.depthTexture).__webglTexture=P.__autoAllocateDepthBuffer?void 0:C,P.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(d,M){let C=Ge.get(d);C.__webglFramebuffer=M,C.__useDefaultFramebuffer=M===void 0},this.setRenderTarget=function(d,M=0,C=0){fe=d,q=M,K=C;let P=null,U=!1,N=!1;if(d){let H=Ge.get(d);if(H.__useDefaultFramebuffer!==void 0){Ce.bindFramebuffer(V.FRAMEBUFFER,H.__webglFramebuffer),ce.copy(d.viewport),we.copy(d.scissor),De=d.scissorTest,Ce.viewport(ce),Ce.scissor(we),Ce.setScissorTest(De),J=-1;return}else if(H.__webglFramebuffer===void 0)je.setupRenderTarget(d);else if(H.__hasExternalTextures)je.rebindTextures(d,Ge.get(d.texture).__webglTexture,Ge.get(d.depthTexture).__webglTexture);else if(d.depthBuffer){let re=d.depthTexture;if(H.__boundDepthTexture!==re){if(re!==null&&Ge.has(re)&&(d.width!==re.image.width||d.height!==re.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(d)}}let G=d.texture;(G.isData3DTexture||G.isDataArrayTexture||G.isCompressedArrayTexture)&&(N=!0);let Y=Ge.get(d).__webglFramebuffer;d.isWebGLCubeRenderTarget?(Array.isArray(Y[M])?P=Y[M][C]:P=Y[M],U=!0):d.samples>0&&je.useMultisampledRTT(d)===!1?P=Ge.get(d).__webglMultisampledFramebuffer:Array.isArray(Y)?P=Y[C]:P=Y,ce.copy(d.viewport),we.copy(d.scissor),De=d.scissorTest}else ce.copy(Ve).multiplyScalar(me).floor(),we.copy(ft).multiplyScalar(me).floor(),De=mt;if(C!==0&&(P=z),Ce.bindFramebuffer(V.FRAMEBUFFER,P)&&Ce.drawBuffers(d,P),Ce.viewport(ce),Ce.scissor(we),Ce.setScissorTest(De),U){let H=Ge.get(d.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+M,H.__webglTexture,C)}else if(N){let H=M;for(let G=0;G<d.textures.length;G++){let Y=Ge.get(d.textures[G]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+G,Y.__webglTexture,C,H)}}else if(d!==null&&C!==0){let H=Ge.get(d.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,H.__webglTexture,C)}J=-1};function _(d){let M=Ge.get(d);return(M.__readFormat!==d.format||M.__readType!==d.type)&&(M.__readFormat=d.format,M.__readType=d.type,M.__formatReadable=Ct.textureFormatReadable(d.format),M.__typeReadable=Ct.textureTypeReadable(d.type)),M}this.readRenderTargetPixels=function(d,M,C,P,U,N,X,H=0){if(!(d&&d.isWebGLRenderTarget)){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let G=Ge.get(d).__webglFramebuffer;if(d.isWebGLCubeRenderTarget&&X!==void 0&&(G=G[X],Array.isArray(G)&&(G=G[0])),G){Ce.bindFramebuffer(V.FRAMEBUFFER,G);try{let Y=d.textures[H],re=Y.format,Q=Y.type;d.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+H);let ee=_(Y);if(ee.__formatReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ee.__typeReadable===!1){Ke("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}M>=0&&M<=d.width-P&&C>=0&&C<=d.height-U&&V.readPixels(M,C,P,U,ve.convert(re),ve.convert(Q),N)}finally{let Y=fe!==null?Ge.get(fe).__webglFramebuffer:null;Ce.bindFramebuffer(V.FRAMEBUFFER,Y)}}},this.readRenderTargetPixelsAsync=async function(d,M,C,P,U,N,X,H=0){if(!(d&&d.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let G=Ge.get(d).__webglFramebuffer;if(d.isWebGLCubeRenderTarget&&X!==void 0&&(G=G[X],Array.isArray(G)&&(G=G[0])),G)if(M>=0&&M<=d.width-P&&C>=0&&C<=d.height-U){Ce.bindFramebuffer(V.FRAMEBUFFER,G);let Y=d.textures[H],re=Y.format,Q=Y.type;d.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+H);let ee=_(Y);if(ee.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ee.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ue=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,ue),V.bufferData(V.PIXEL_PACK_BUFFER,N.byteLength,V.STREAM_READ),V.readPixels(M,C,P,U,ve.convert(re),ve.convert(Q),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let de=fe!==null?Ge.get(fe).__webglFramebuffer:null;Ce.bindFramebuffer(V.FRAMEBUFFER,de);let pe=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await em(V,pe,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,ue),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,N),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(ue),V.deleteSync(pe),N}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(d,M=null,C=0){let P=Math.pow(2,-C),U=Math.floor(d.image.width*P),N=Math.floor(d.image.height*P),X=M!==null?M.x:0,H=M!==null?M.y:0;je.setTexture2D(d,0),V.copyTexSubImage2D(V.TEXTURE_2D,C,0,0,X,H,U,N),Ce.unbindTexture()},this.copyTextureToTexture=function(d,M,C=null,P=null,U=0,N=0){let X,H,G,Y,re,Q,ee,ue,de,pe=d.isCompressedTexture?d.mipmaps[N]:d.image;if(C!==null)X=C.max.x-C.min.x,H=C.max.y-C.min.y,G=C.isBox3?C.max.z-C.min.z:1,Y=C.min.x,re=C.min.y,Q=C.isBox3?C.min.z:0;else{let Oe=Math.pow(2,-U);X=Math.floor(pe.width*Oe),H=Math.floor(pe.height*Oe),d.isDataArrayTexture?G=pe.depth:d.isData3DTexture?G=Math.floor(pe.depth*Oe):G=1,Y=0,re=0,Q=0}P!==null?(ee=P.x,ue=P.y,de=P.z):(ee=0,ue=0,de=0);let Te=ve.convert(M.format),We=ve.convert(M.type),he;M.isData3DTexture?(je.setTexture3D(M,0),he=V.TEXTURE_3D):M.isDataArrayTexture||M.isCompressedArrayTexture?(je.setTexture2DArray(M,0),he=V.TEXTURE_2D_ARRAY):(je.setTexture2D(M,0),he=V.TEXTURE_2D),Ce.activeTexture(V.TEXTURE0),Ce.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,M.flipY),Ce.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),Ce.pixelStorei(V.UNPACK_ALIGNMENT,M.unpackAlignment);let Ye=Ce.getParameter(V.UNPACK_ROW_LENGTH),ye=Ce.getParameter(V.UNPACK_IMAGE_HEIGHT),Pe=Ce.getParameter(V.UNPACK_SKIP_PIXELS),Ne=Ce.getParameter(V.UNPACK_SKIP_ROWS),gt=Ce.getParameter(V.UNPACK_SKIP_IMAGES);Ce.pixelStorei(V.UNPACK_ROW_LENGTH,pe.width),Ce.pixelStorei(V.UNPACK_IMAGE_HEIGHT,pe.height),Ce.pixelStorei(V.UNPACK_SKIP_PIXELS,Y),Ce.pixelStorei(V.UNPACK_SKIP_ROWS,re),Ce.pixelStorei(V.UNPACK_SKIP_IMAGES,Q);let nt=d.isDataArrayTexture||d.isData3DTexture,qe=M.isDataArrayTexture||M.isData3DTexture;if(d.isDepthTexture){let Oe=Ge.get(d),lt=Ge.get(M),Ft=Ge.get(Oe.__renderTarget),Ze=Ge.get(lt.__renderTarget);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,Ft.__webglFramebuffer),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,Ze.__webglFramebuffer);for(let St=0;St<G;St++)nt&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ge.get(d).__webglTexture,U,Q+St),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ge.get(M).__webglTexture,N,de+St)),V.blitFramebuffer(Y,re,Y+X,re+H,ee,ue,ee+X,ue+H,V.DEPTH_BUFFER_BIT,V.NEAREST);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(U!==0||d.isRenderTargetTexture||Ge.has(d)){let Oe=Ge.get(d),lt=Ge.get(M);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,D),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,W);for(let Ft=0;Ft<G;Ft++)nt?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Oe.__webglTexture,U,Q+Ft):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Oe.__webglTexture,U),qe?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,lt.__webglTexture,N,de+Ft):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,lt.__webglTexture,N),U!==0?V.blitFramebuffer(Y,re,Y+X,re+H,ee,ue,ee+X,ue+H,V.COLOR_BUFFER_BIT,V.NEAREST):qe?V.copyTexSubImage3D(he,N,ee,ue,de+Ft,Y,re,X,H):V.copyTexSubImage2D(he,N,ee,ue,Y,re,X,H);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else qe?d.isDataTexture||d.isData3DTexture?V.texSubImage3D(he,N,ee,ue,de,X,H,G,Te,We,pe.data):M.isCompressedArrayTexture?V.compressedTexSubImage3D(he,N,ee,ue,de,X,H,G,Te,pe.data):V.texSubImage3D(he,N,ee,ue,de,X,H,G,Te,We,pe):d.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,N,ee,ue,X,H,Te,We,pe.data):d.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,N,ee,ue,pe.width,pe.height,Te,pe.data):V.texSubImage2D(V.TEXTURE_2D,N,ee,ue,X,H,Te,We,pe);Ce.pixelStorei(V.UNPACK_ROW_LENGTH,Ye),Ce.pixelStorei(V.UNPACK_IMAGE_HEIGHT,ye),Ce.pixelStorei(V.UNPACK_SKIP_PIXELS,Pe),Ce.pixelStorei(V.UNPACK_SKIP_ROWS,Ne),Ce.pixelStorei(V.UNPACK_SKIP_IMAGES,gt),N===0&&M.generateMipmaps===!0&&M.mipmapsAutoUpdate===!0&&V.generateMipmap(he),Ce.unbindTexture()},this.initRenderTarget=function(d){Ge.get(d).__webglFramebuffer===void 0&&je.setupRenderTarget(d)},this.initTexture=function(d){d.isCubeTexture?je.setTextureCube(d,0):d.isData3DTexture?je.setTexture3D(d,0):d.isDataArrayTexture||d.isCompressedArrayTexture?je.setTexture2DArray(d,0):je.setTexture2D(d,0),Ce.unbindTexture()},this.resetState=function(){q=0,K=0,fe=null,Ce.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return qn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=rt._getDrawingBufferColorSpace(e),t.unpackColorSpace=rt._getUnpackColorSpace()}};var oi=new Xe,Rc=class extends Hn{constructor(e){super(e),this.propertyNameMapping={},this.customPropertyMapping={}}load(e,t,n,s){let r=this,o=new ji(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},n,s)}setPropertyNameMapping(e){this.propertyNameMapping=e}setCustomPropertyNameMapping(e){this.customPropertyMapping=e}parse(e){function t(S,w=0){let T=/^ply([\s\S]*)end_header(\r\n|\r|\n)/,E="",x=T.exec(S);x!==null&&(E=x[1]);let b={comments:[],elements:[],headerLength:w,objInfo:""},L=E.split(/\r\n|\r|\n/),I;function F(B,z){let D={type:B[0]};return D.type==="list"?(D.name=B[3],D.countType=B[1],D.itemType=B[2]):D.name=B[1],D.name in z&&(D.name=z[D.name]),D}for(let B=0;B<L.length;B++){let z=L[B];if(z=z.trim(),z==="")continue;let D=z.split(/\s+/),W=D.shift();switch(z=D.join(" "),W){case"format":b.format=D[0],b.version=D[1];break;case"comment":b.comments.push(z);break;case"element":I!==void 0&&b.elements.push(I),I={},I.name=D[0],I.count=parseInt(D[1]),I.properties=[];break;case"property":I.properties.push(F(D,A.propertyNameMapping));break;case"obj_info":b.objInfo=z;break;default:console.log("unhandled",W,D)}}return I!==void 0&&b.elements.push(I),b}function n(S,w){switch(w){case"char":case"uchar":case"short":case"ushort":case"int":case"uint":case"int8":case"uint8":case"int16":case"uint16":case"int32":case"uint32":return parseInt(S);case"float":case"double":case"float32":case"float64":return parseFloat(S)}}function s(S,w){let T={};for(let E=0;E<S.length;E++){if(w.empty())return null;if(S[E].type==="list"){let x=[],b=n(w.next(),S[E].countType);for(let L=0;L<b;L++){if(w.empty())return null;x.push(n(w.next(),S[E].itemType))}T[S[E].name]=x}else T[S[E].name]=n(w.next(),S[E].type)}return T}function r(){let S={indices:[],vertices:[],normals:[],uvs:[],faceVertexUvs:[],colors:[],faceVertexColors:[],descriptors:{}};for(let w of Object.keys(A.customPropertyMapping))S[w]=[];return S}function o(S){switch(S){case"int8":case"char":return yo;case"uint8":case"uchar":return xo;case"int16":case"short":return bo;case"uint16":case"ushort":return Fs;case"int32":case"int":return Mo;case"uint32":case"uint":return Us;case"float32":case"float":return kt;case"float64":case"double":return zu}}function a(S){switch(S){case"uchar":case"uint8":return 1/255;case"ushort":case"uint16":return 1/65535;case"float":case"float32":case"double":case"float64":return 1;default:return 1/255}}function l(S){return S==="float"||S==="float32"||S==="double"||S==="float64"}function c(S){function w(fe){for(let J of fe){let ae=S.find(ce=>ce.name===J);if(ae)return ae}return null}let T=w(["x","px","posx"]),E=w(["y","py","posy"]),x=w(["z","pz","posz"]),b=w(["nx","normalx"]),L=w(["ny","normaly"]),I=w(["nz","normalz"]),F=w(["s","u","texture_u","tx"]),B=w(["t","v","texture_v","ty"]),z=w(["red","diffuse_red","r","diffuse_r"]),D=w(["green","diffuse_green","g","diffuse_g"]),W=w(["blue","diffuse_blue","b","diffuse_b"]),q=w(["texcoord"]),K={};for(let fe of Object.keys(A.customPropertyMapping)){let ae=A.customPropertyMapping[fe].map(De=>S.find(ie=>ie.name===De)),ce=ae.filter(De=>De).map(De=>De.type),we=ce.length>0&&ce.every(De=>De===ce[0]);K[fe]={type:we?ce[0]:"float32",usage:ae.every(De=>De!==void 0)}}return{position:{names:[T?T.name:"x",E?E.name:"y",x?x.name:"z"],type:T?T.type:"float32",usage:!!(T&&E&&x)},normal:{names:[b?b.name:"nx",L?L.name:"ny",I?I.name:"nz"],type:b?b.type:"float32",usage:!!(b&&L&&I)},uv:{names:[F?F.name:"s",B?B.name:"t"],type:F?F.type:"float32",usage:!!(F&&B)},texcoord:{type:q?q.itemType:"float32",usage:!!q},color:{names:[z?z.name:"red",D?D.name:"green",W?W.name:"blue"],type:z?z.type:"uchar",usage:!!(z&&D&&W)},custom:K}}function h(S,w){let T=r(),E=/end_header\s+(\S[\s\S]*\S|\S)\s*$/,x,b;(b=E.exec(S))!==null?x=b[1].split(/\s+/):x=[];let L=new Hu(x);e:for(let I=0;I<w.elements.length;I++){let F=w.elements[I],B=c(F.properties);T.descriptors[F.name]=B;for(let z=0;z<F.count;z++){let D=s(F.properties,L);if(!D)break e;f(T,F.name,D,B)}}return u(T)}function u(S){let w=new Lt,T=S.descriptors.vertex;S.indices.length>0&&w.setIndex(S.indices);let E=o(T?T.position.type:"float32");if(w.setAttribute("position",new E(S.vertices,3)),S.normals.length>0){let x=o(T.normal.type);w.setAttribute("normal",new x(S.normals,3))}if(S.uvs.length>0){let x=o(T.uv.type);w.setAttribute("uv",new x(S.uvs,2))}if(S.colors.length>0){let x=T.color.type,b=!l(x),L=o(x);w.setAttribute("color",new L(S.colors,3,b))}for(let x of Object.keys(A.customPropertyMapping))if(S[x].length>0){let b=o(T.custom[x].type);w.setAttribute(x,new b(S[x],A.customPropertyMapping[x].length))}if(S.faceVertexUvs.length>0||S.faceVertexColors.length>0){if(w=w.toNonIndexed(),S.faceVertexUvs.length>0){let x=o(S.descriptors.face.texcoord.type);w.setAttribute("uv",new x(S.faceVertexUvs,2))}if(S.faceVertexColors.length>0){let x=S.descriptors.face.color.type,b=!l(x),L=o(x);w.setAttribute("color",new L(S.faceVertexColors,3,b))}}return w.computeBoundingSphere(),w}function f(S,w,T,E){if(w==="vertex"){let{position:x,normal:b,uv:L,color:I}=E;if(x.usage&&S.vertices.push(T[x.names[0]],T[x.names[1]],T[x.names[2]]),b.usage&&S.normals.push(T[b.names[0]],T[b.names[1]],T[b.names[2]]),L.usage&&S.uvs.push(T[L.names[0]],T[L.names[1]]),I.usage){let F=a(I.type),B=l(I.type);oi.setRGB(T[I.names[0]]*F,T[I.names[1]]*F,T[I.names[2]]*F,Xt);let z=1/F;S.colors.push(B?oi.r:Math.round(oi.r*z),B?oi.g:Math.round(oi.g*z),B?oi.b:Math.round(oi.b*z))}for(let F of Object.keys(A.customPropertyMapping))for(let B of A.customPropertyMapping[F])S[F].push(T[B])}else if(w==="face"){let x=T.vertex_indices||T.vertex_index,b=T.texcoord;x.length===3?(S.indices.push(x[0],x[1],x[2]),b&&b.length===6&&(S.faceVertexUvs.push(b[0],b[1]),S.faceVertexUvs.push(b[2],b[3]),S.faceVertexUvs.push(b[4],b[5]))):x.length===4&&(S.indices.push(x[0],x[1],x[2]),S.indices.push(x[0],x[2],x[3]),b&&b.length===8&&(S.faceVertexUvs.push(b[0],b[1]),S.faceVertexUvs.push(b[2],b[3]),S.faceVertexUvs.push(b[4],b[5]),S.faceVertexUvs.push(b[0],b[1]),S.faceVertexUvs.push(b[4],b[5]),S.faceVertexUvs.push(b[6],b[7])));let{color:L}=E;if(L.usage){let I=a(L.type);oi.setRGB(T[L.names[0]]*I,T[L.names[1]]*I,T[L.names[2]]*I,Xt);let F=1/I,B=oi.r*F,z=oi.g*F,D=oi.b*F;S.faceVertexColors.push(B,z,D),S.faceVertexColors.push(B,z,D),S.faceVertexColors.push(B,z,D),x.length===4&&(S.faceVertexColors.push(B,z,D),S.faceVertexColors.push(B,z,D),S.faceVertexColors.push(B,z,D))}}}function p(S,w){let T={},E=0;for(let x=0;x<w.length;x++){let b=w[x],L=b.valueReader;if(b.type==="list"){let I=[],F=b.countReader.read(S+E);E+=b.countReader.size;for(let B=0;B<F;B++)I.push(L.read(S+E)),E+=L.size;T[b.name]=I}else T[b.name]=L.read(S+E),E+=L.size}return[T,E]}function g(S,w,T){function E(x,b,L){switch(b){case"int8":case"char":return{read:I=>x.getInt8(I),size:1};case"uint8":case"uchar":return{read:I=>x.getUint8(I),size:1};case"int16":case"short":return{read:I=>x.getInt16(I,L),size:2};case"uint16":case"ushort":return{read:I=>x.getUint16(I,L),size:2};case"int32":case"int":return{read:I=>x.getInt32(I,L),size:4};case"uint32":case"uint":return{read:I=>x.getUint32(I,L),size:4};case"float32":case"float":return{read:I=>x.getFloat32(I,L),size:4};case"float64":case"double":return{read:I=>x.getFloat64(I,L),size:8}}}for(let x=0,b=S.length;x<b;x++){let L=S[x];L.type==="list"?(L.countReader=E(w,L.countType,T),L.valueReader=E(w,L.itemType,T)):L.valueReader=E(w,L.type,T)}}function y(S,w){let T=r(),E=w.format==="binary_little_endian",x=new DataView(S,w.headerLength),b,L=0;for(let I=0;I<w.elements.length;I++){let F=w.elements[I],B=F.properties,z=c(B);T.descriptors[F.name]=z,g(B,x,E);for(let D=0;D<F.count;D++){b=p(L,B),L+=b[1];let W=b[0];f(T,F.name,W,z)}}return u(T)}function m(S){let w=0,T=!0,E="",x=[],b=new TextDecoder().decode(S.subarray(0,5)),L=/^ply\r\n/.test(b);do{let I=String.fromCharCode(S[w++]);I!==`
`&&I!=="\r"?E+=I:(E==="end_header"&&(T=!1),E!==""&&(x.push(E),E=""))}while(T&&w<S.length);return L===!0&&w++,{headerText:x.join("\r")+"\r",headerLength:w}}let v,A=this;if(e instanceof ArrayBuffer){let S=new Uint8Array(e),{headerText:w,headerLength:T}=m(S),E=t(w,T);if(E.format==="ascii"){let x=new TextDecoder().decode(S);v=h(x,E)}else v=y(e,E)}else v=h(e,t(e));return v}},zu=class extends ut{constructor(e,t,n){super(new Float64Array(e),t,n)}},Hu=class{constructor(e){this.arr=e,this.i=0}empty(){return this.i>=this.arr.length}next(){return this.arr[this.i++]}};function km(i,e=1e-4){e=Math.max(e,Number.EPSILON);let t={},n=i.getIndex(),s=i.getAttribute("position"),r=n?n.count:s.count,o=0,a=Object.keys(i.attributes),l=[],c=new Map,h=[],u=["getX","getY","getZ","getW"],f=e*.5,p=Math.log10(1/e),g=Math.pow(10,p),y=f*g;for(let v=0;v<r;v++){let A=n?n.getX(v):v,S="";for(let w=0,T=a.length;w<T;w++){let E=a[w],x=i.getAttribute(E),b=x.itemSize;for(let L=0;L<b;L++)S+=`${Math.trunc(x[u[L]](A)*g+y)},`}S in t?h.push(t[S]):(l.push(A),t[S]=o,h.push(o),o++)}let m=i.clone();for(let v in i.attributes)m.setAttribute(v,Bm(i.attributes[v],l,c));for(let v in i.morphAttributes)m.morphAttributes[v]=i.morphAttributes[v].map(A=>Bm(A,l,c));return m.setIndex(h),m}function Gu(i,e){if(e===vu)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===Ur||e===Ko){let t=i.getIndex();if(t===null){let r=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)r.push(a);i.setIndex(r),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,s=[];if(e===Ur)for(let r=1;r<=n;r++)s.push(t.getX(0)),s.push(t.getX(r)),s.push(t.getX(r+1));else for(let r=0;r<n;r++)r%2===0?(s.push(t.getX(r)),s.push(t.getX(r+1)),s.push(t.getX(r+2))):(s.push(t.getX(r+2)),s.push(t.getX(r+1)),s.push(t.getX(r)));return s.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(s),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function Bm(i,e,t=new Map){let n=i.isInterleavedBufferAttribute,s=n?i.data:i,r=n?s.stride:i.itemSize,o=n?t.get(s):void 0;if(o===void 0){let l=new s.array.constructor(e.length*r);for(let c=0;c<e.length;c++)for(let h=0;h<r;h++)l[c*r+h]=s.array[e[c]*r+h];o=n?new s.constructor(l,r,s.meshPerAttribute):new i.constructor(l,i.itemSize,i.normalized,i.meshPerAttribute),o.setUsage(s.usage),n&&t.set(s,o)}let a=n?new i.constructor(o,i.itemSize,i.offset,i.normalized):o;return a.name=i.name,n||(a.gpuType=i.gpuType),a}function zm(i){let e=new Map,t=new Map,n=i.clone();return Hm(i,n,function(s,r){e.set(r,s),t.set(s,r)}),n.traverse(function(s){if(!s.isSkinnedMesh)return;let r=s,o=e.get(s),a=o.skeleton.bones;r.skeleton=o.skeleton.clone(),r.bindMatrix.copy(o.bindMatrix),r.skeleton.bones=a.map(function(l){return t.get(l)}),r.bind(r.skeleton,r.bindMatrix)}),n}function Hm(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)Hm(i.children[n],e.children[n],t)}var Cc=class extends Hn{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new Zu(t)}),this.register(function(t){return new Ku(t)}),this.register(function(t){return new Ju(t)}),this.register(function(t){return new af(t)}),this.register(function(t){return new lf(t)}),this.register(function(t){return new cf(t)}),this.register(function(t){return new Qu(t)}),this.register(function(t){return new ef(t)}),this.register(function(t){return new tf(t)}),this.register(function(t){return new nf(t)}),this.register(function(t){return new Yu(t)}),this.register(function(t){return new sf(t)}),this.register(function(t){return new ju(t)}),this.register(function(t){return new of(t)}),this.register(function(t){return new rf(t)}),this.register(function(t){return new Xu(t)}),this.register(function(t){return new Ic(t,ot.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new Ic(t,ot.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new hf(t)})}load(e,t,n,s){let r=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let c=Qi.extractUrlBase(e);o=Qi.resolveURL(c,this.path)}else o=Qi.extractUrlBase(e);this.manager.itemStart(e);let a=function(c){s?s(c):console.error(c),r.manager.itemError(e),r.manager.itemEnd(e)},l=new ji(this.manager);l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.path),l.setResponseType("arraybuffer"),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials),l.load(e,function(c){try{r.parse(c,o,function(h){t(h),r.manager.itemEnd(e)},a)}catch(h){a(h)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,s){let r,o={},a={},l=new TextDecoder;if(typeof e=="string")r=JSON.parse(e);else if(e instanceof ArrayBuffer)if(l.decode(new Uint8Array(e,0,4))===Xm){try{o[ot.KHR_BINARY_GLTF]=new uf(e)}catch(u){s&&s(u);return}r=JSON.parse(o[ot.KHR_BINARY_GLTF].content)}else r=JSON.parse(l.decode(e));else r=e;if(r.asset===void 0||r.asset.version[0]<2){s&&s(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let c=new _f(r,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});c.fileLoader.setRequestHeader(this.requestHeader);for(let h=0;h<this.pluginCallbacks.length;h++){let u=this.pluginCallbacks[h](c);u.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[u.name]=u,o[u.name]=!0}if(r.extensionsUsed)for(let h=0;h<r.extensionsUsed.length;++h){let u=r.extensionsUsed[h],f=r.extensionsRequired||[];switch(u){case ot.KHR_MATERIALS_UNLIT:o[u]=new qu;break;case ot.KHR_DRACO_MESH_COMPRESSION:o[u]=new ff(r,this.dracoLoader);break;case ot.KHR_TEXTURE_TRANSFORM:o[u]=new df;break;case ot.KHR_MESH_QUANTIZATION:o[u]=new pf;break;default:f.indexOf(u)>=0&&a[u]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+u+'".')}}c.setExtensions(o),c.setPlugins(a),c.parse(n,s)}parseAsync(e,t){let n=this;return new Promise(function(s,r){n.parse(e,t,s,r)})}};function DM(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function Gt(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var ot={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},Xu=class{constructor(e){this.parser=e,this.name=ot.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,s=t.length;n<s;n++){let r=t[n];r.extensions&&r.extensions[this.name]&&r.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,r.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,s=t.cache.get(n);if(s)return s;let r=t.json,l=((r.extensions&&r.extensions[this.name]||{}).lights||[])[e],c,h=new Xe(16777215);l.color!==void 0&&h.setRGB(l.color[0],l.color[1],l.color[2],Ot);let u=l.range!==void 0?l.range:0;switch(l.type){case"directional":c=new Bo(h),c.target.position.set(0,0,-1),c.add(c.target);break;case"point":c=new Oo(h),c.distance=u;break;case"spot":c=new Uo(h),c.distance=u,l.spot=l.spot||{},l.spot.innerConeAngle=l.spot.innerConeAngle!==void 0?l.spot.innerConeAngle:0,l.spot.outerConeAngle=l.spot.outerConeAngle!==void 0?l.spot.outerConeAngle:Math.PI/4,c.angle=l.spot.outerConeAngle,c.penumbra=1-l.spot.innerConeAngle/l.spot.outerConeAngle,c.target.position.set(0,0,-1),c.add(c.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+l.type)}return c.position.set(0,0,0),Ai(c,l),l.intensity!==void 0&&(c.intensity=l.intensity),c.name=t.createUniqueName(l.name||"light_"+e),s=Promise.resolve(c),t.cache.add(n,s),s}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,r=n.json.nodes[e],a=(r.extensions&&r.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(l){return n._getNodeRef(t.cache,a,l)})}},qu=class{constructor(){this.name=ot.KHR_MATERIALS_UNLIT}getMaterialType(){return ii}extendParams(e,t,n){let s=[];e.color=new Xe(1,1,1),e.opacity=1;let r=t.pbrMetallicRoughness;if(r){if(Array.isArray(r.baseColorFactor)){let o=r.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],Ot),e.opacity=o[3]}r.baseColorTexture!==void 0&&s.push(n.assignTexture(e,"map",r.baseColorTexture,Xt))}return Promise.all(s)}},Yu=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},Zu=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(s.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let r=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new it(r,r)}return Promise.all(s)}},Ku=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(s)}},Ju=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_DISPERSION}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},ju=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(s)}},Qu=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_SHEEN}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(t.sheenColor=new Xe(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let r=n.sheenColorFactor;t.sheenColor.setRGB(r[0],r[1],r[2],Ot)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,Xt)),n.sheenRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(s)}},ef=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&s.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(s)}},tf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_VOLUME}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let r=n.attenuationColor||[1,1,1];return t.attenuationColor=new Xe().setRGB(r[0],r[1],r[2],Ot),Promise.all(s)}},nf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_IOR}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},sf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_SPECULAR}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let r=n.specularColorFactor||[1,1,1];return t.specularColor=new Xe().setRGB(r[0],r[1],r[2],Ot),n.specularColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,Xt)),Promise.all(s)}},rf=class{constructor(e){this.parser=e,this.name=ot.EXT_MATERIALS_BUMP}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&s.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(s)}},of=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?Sn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&s.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(s)}},af=class{constructor(e){this.parser=e,this.name=ot.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,s=n.textures[e];if(!s.extensions||!s.extensions[this.name])return null;let r=s.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,r.source,o)}},lf=class{constructor(e){this.parser=e,this.name=ot.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},cf=class{constructor(e){this.parser=e,this.name=ot.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},Ic=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let s=n.extensions[this.name],r=this.parser.getDependency("buffer",s.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return r.then(function(a){let l=s.byteOffset||0,c=s.byteLength||0,h=s.count,u=s.byteStride,f=new Uint8Array(a,l,c);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(h,u,f,s.mode,s.filter).then(function(p){return p.buffer}):o.ready.then(function(){let p=new ArrayBuffer(h*u);return o.decodeGltfBuffer(new Uint8Array(p),h,u,f,s.mode,s.filter),p})})}else return null}},hf=class{constructor(e){this.name=ot.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let s=t.meshes[n.mesh];for(let c of s.primitives)if(c.mode!==Kn.TRIANGLES&&c.mode!==Kn.TRIANGLE_STRIP&&c.mode!==Kn.TRIANGLE_FAN&&c.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],l={};for(let c in o)a.push(this.parser.getDependency("accessor",o[c]).then(h=>(l[c]=h,l[c])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(c=>{let h=c.pop(),u=h.isGroup?h.children:[h],f=c[0].count,p=[];for(let g of u){let y=new et,m=new $,v=new kn,A=new $(1,1,1),S=new Ao(g.geometry,g.material,f);for(let T=0;T<f;T++)l.TRANSLATION&&m.fromBufferAttribute(l.TRANSLATION,T),l.ROTATION&&v.fromBufferAttribute(l.ROTATION,T),l.SCALE&&A.fromBufferAttribute(l.SCALE,T),S.setMatrixAt(T,y.compose(m,v,A));let w=null;for(let T in l)if(T==="_COLOR_0"){let E=l[T];S.instanceColor=new $i(E.array,E.itemSize,E.normalized)}else if(T!=="TRANSLATION"&&T!=="ROTATION"&&T!=="SCALE"){if(w===null){let x=S.geometry;w=new Lt,w.name=x.name;for(let b in x.attributes)w.setAttribute(b,x.attributes[b]);for(let b in x.morphAttributes)w.morphAttributes[b]=x.morphAttributes[b];x.index!==null&&w.setIndex(x.index),w.morphTargetsRelative=x.morphTargetsRelative;for(let b of x.groups)w.addGroup(b.start,b.count,b.materialIndex);x.boundingBox!==null&&(w.boundingBox=x.boundingBox.clone()),x.boundingSphere!==null&&(w.boundingSphere=x.boundingSphere.clone()),w.drawRange.start=x.drawRange.start,w.drawRange.count=x.drawRange.count,w.userData=Object.assign({},x.userData),S.geometry=w}let E=l[T];w.setAttribute(T,new $i(E.array,E.itemSize,E.normalized))}zt.prototype.copy.call(S,g),this.parser.assignFinalMaterial(S),p.push(S)}return h.isGroup?(h.clear(),h.add(...p),h):p[0]}))}},Xm="glTF",ta=12,Gm={JSON:1313821514,BIN:5130562},uf=class{constructor(e){this.name=ot.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,ta),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==Xm)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let s=this.header.length-ta,r=new DataView(e,ta),o=0;for(;o<s;){let a=r.getUint32(o,!0);o+=4;let l=r.getUint32(o,!0);if(o+=4,l===Gm.JSON){let c=new Uint8Array(e,ta+o,a);this.content=n.decode(c)}else if(l===Gm.BIN){let c=ta+o;this.body=e.slice(c,c+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},ff=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=ot.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,s=this.dracoLoader,r=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},l={},c={};for(let h in o){let u=gf[h]||h.toLowerCase();a[u]=o[h]}for(let h in e.attributes){let u=gf[h]||h.toLowerCase();if(o[h]!==void 0){let f=n.accessors[e.attributes[h]],p=kr[f.componentType];c[u]=p.name,l[u]=f.normalized===!0}}return t.getDependency("bufferView",r).then(function(h){return new Promise(function(u,f){s.decodeDracoFile(h,function(p){for(let g in p.attributes){let y=p.attributes[g],m=l[g];m!==void 0&&(y.normalized=m)}u(p)},a,c,Ot,f)})})}},df=class{constructor(){this.name=ot.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),s=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*s,e.offset.x,-e.repeat.x*s,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},pf=class{constructor(){this.name=ot.KHR_MESH_QUANTIZATION}},Pc=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s*3+s;for(let o=0;o!==s;o++)t[o]=n[r+o];return t}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=a*2,c=a*3,h=s-t,u=(n-t)/h,f=u*u,p=f*u,g=e*c,y=g-c,m=-2*p+3*f,v=p-f,A=1-m,S=v-f+u;for(let w=0;w!==a;w++){let T=o[y+w+a],E=o[y+w+l]*h,x=o[g+w+a],b=o[g+w]*h;r[w]=A*T+S*E+m*x+v*b}return r}},FM=new kn,mf=class extends Pc{interpolate_(e,t,n,s){let r=super.interpolate_(e,t,n,s);return FM.fromArray(r).normalize().toArray(r),r}},Kn={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},kr={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},Vm={9728:Pt,9729:Et,9984:Ul,9985:Dr,9986:Ws,9987:Vn},Wm={33071:Rn,33648:gr,10497:_s},Vu={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},gf={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},bs={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},UM={CUBICSPLINE:void 0,LINEAR:Ns,STEP:Ls},Wu={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function OM(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new ks({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:Zn})),i.DefaultMaterial}function qs(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function Ai(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function BM(i,e,t){let n=!1,s=!1,r=!1;for(let c=0,h=e.length;c<h;c++){let u=e[c];if(u.POSITION!==void 0&&(n=!0),u.NORMAL!==void 0&&(s=!0),u.COLOR_0!==void 0&&(r=!0),n&&s&&r)break}if(!n&&!s&&!r)return Promise.resolve(i);let o=[],a=[],l=[];for(let c=0,h=e.length;c<h;c++){let u=e[c];if(n){let f=u.POSITION!==void 0?t.getDependency("accessor",u.POSITION):i.attributes.position;o.push(f)}if(s){let f=u.NORMAL!==void 0?t.getDependency("accessor",u.NORMAL):i.attributes.normal;a.push(f)}if(r){let f=u.COLOR_0!==void 0?t.getDependency("accessor",u.COLOR_0):i.attributes.color;l.push(f)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l)]).then(function(c){let h=c[0],u=c[1],f=c[2];return n&&(i.morphAttributes.position=h),s&&(i.morphAttributes.normal=u),r&&(i.morphAttributes.color=f),i.morphTargetsRelative=!0,i})}function kM(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,s=t.length;n<s;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function zM(i){let e,t=i.extensions&&i.extensions[ot.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+$u(t.attributes):e=i.indices+":"+$u(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,s=i.targets.length;n<s;n++)e+=":"+$u(i.targets[n]);return e}function $u(i){let e="",t=Object.keys(i).sort();for(let n=0,s=t.length;n<s;n++)e+=t[n]+":"+i[t[n]]+";";return e}function vf(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function HM(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var GM=new et,_f=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new DM,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,s=-1,r=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let l=a.match(/Version\/(\d+)/);s=n&&l?parseInt(l[1],10):-1,r=a.indexOf("Firefox")>-1,o=r?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&s<17||r&&o<98?(this.textureLoader=new Do(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new ko(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new ji(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,s=this.json,r=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][s.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:s.asset,parser:n,userData:{}};return qs(r,a,s),Ai(a,s),Promise.all(n._invokeAll(function(l){return l.afterRoot&&l.afterRoot(a)})).then(function(){for(let l of a.scenes)l.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let s=0,r=t.length;s<r;s++){let o=t[s].joints;for(let a=0,l=o.length;a<l;a++)e[o[a]].isBone=!0}for(let s=0,r=e.length;s<r;s++){let o=e[s];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let s=n.clone(),r=(o,a)=>{let l=this.associations.get(o);l!=null&&this.associations.set(a,l);for(let[c,h]of o.children.entries())r(h,a.children[c])};return r(n,s),s.name+="_instance_"+e.uses[t]++,s}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let s=e(t[n]);if(s)return s}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let s=0;s<t.length;s++){let r=e(t[s]);r&&n.push(r)}return n}getDependency(e,t){let n=e+":"+t,s=this.cache.get(n);if(!s){switch(e){case"scene":s=this.loadScene(t);break;case"node":s=this._invokeOne(function(r){return r.loadNode&&r.loadNode(t)});break;case"mesh":s=this._invokeOne(function(r){return r.loadMesh&&r.loadMesh(t)});break;case"accessor":s=this.loadAccessor(t);break;case"bufferView":s=this._invokeOne(function(r){return r.loadBufferView&&r.loadBufferView(t)});break;case"buffer":s=this.loadBuffer(t);break;case"material":s=this._invokeOne(function(r){return r.loadMaterial&&r.loadMaterial(t)});break;case"texture":s=this._invokeOne(function(r){return r.loadTexture&&r.loadTexture(t)});break;case"skin":s=this.loadSkin(t);break;case"animation":s=this._invokeOne(function(r){return r.loadAnimation&&r.loadAnimation(t)});break;case"camera":s=this.loadCamera(t);break;default:if(s=this._invokeOne(function(r){return r!=this&&r.getDependency&&r.getDependency(e,t)}),!s)throw new Error("Unknown type: "+e);break}this.cache.add(n,s)}return s}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,s=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(s.map(function(r,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[ot.KHR_BINARY_GLTF].body);let s=this.options;return new Promise(function(r,o){n.load(Qi.resolveURL(t.uri,s.path),r,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let s=t.byteLength||0,r=t.byteOffset||0;return n.slice(r,r+s)})}loadAccessor(e){let t=this,n=this.json,s=this.json.accessors[e];if(s.bufferView===void 0&&s.sparse===void 0){let o=Vu[s.type],a=kr[s.componentType],l=s.normalized===!0,c=new a(s.count*o);return Promise.resolve(new ut(c,o,l))}let r=[];return s.bufferView!==void 0?r.push(this.getDependency("bufferView",s.bufferView)):r.push(null),s.sparse!==void 0&&(r.push(this.getDependency("bufferView",s.sparse.indices.bufferView)),r.push(this.getDependency("bufferView",s.sparse.values.bufferView))),Promise.all(r).then(function(o){let a=o[0],l=Vu[s.type],c=kr[s.componentType],h=c.BYTES_PER_ELEMENT,u=h*l,f=s.byteOffset||0,p=s.bufferView!==void 0?n.bufferViews[s.bufferView].byteStride:void 0,g=s.normalized===!0,y,m;if(p&&p!==u){let v=Math.floor(f/p),A="InterleavedBuffer:"+s.bufferView+":"+s.componentType+":"+v+":"+s.count,S=t.cache.get(A);S||(y=new c(a,v*p,s.count*p/h),S=new Mr(y,p/h),t.cache.add(A,S)),m=new Sr(S,l,f%p/h,g)}else a===null?y=new c(s.count*l):y=new c(a,f,s.count*l),m=new ut(y,l,g);if(s.sparse!==void 0){let v=Vu.SCALAR,A=kr[s.sparse.indices.componentType],S=s.sparse.indices.byteOffset||0,w=s.sparse.values.byteOffset||0,T=new A(o[1],S,s.sparse.count*v),E=new c(o[2],w,s.sparse.count*l);a!==null&&(m=new ut(m.array.slice(),m.itemSize,m.normalized)),m.normalized=!1;for(let x=0,b=T.length;x<b;x++){let L=T[x];if(m.setX(L,E[x*l]),l>=2&&m.setY(L,E[x*l+1]),l>=3&&m.setZ(L,E[x*l+2]),l>=4&&m.setW(L,E[x*l+3]),l>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}m.normalized=g}return m})}loadTexture(e){let t=this.json,n=this.options,r=t.textures[e].source,o=t.images[r],a=this.textureLoader;if(o.uri){let l=n.manager.getHandler(o.uri);l!==null&&(a=l)}return this.loadTextureImage(e,r,a)}loadTextureImage(e,t,n){let s=this,r=this.json,o=r.textures[e],a=r.images[t],l=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[l])return this.textureCache[l];let c=this.loadImageSource(t,n).then(function(h){h.flipY=!1,h.name=o.name||a.name||"",h.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(h.name=a.uri);let f=(r.samplers||{})[o.sampler]||{};return h.magFilter=Vm[f.magFilter]||Et,h.minFilter=Vm[f.minFilter]||Vn,h.wrapS=Wm[f.wrapS]||_s,h.wrapT=Wm[f.wrapT]||_s,h.generateMipmaps=!h.isCompressedTexture&&h.minFilter!==Pt&&h.minFilter!==Et,s.associations.set(h,{textures:e}),h}).catch(function(){return null});return this.textureCache[l]=c,c}loadImageSource(e,t){let n=this,s=this.json,r=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(f=>f.clone());let o=s.images[e],a=self.URL||self.webkitURL,l=o.uri||"",c=!1,h;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)h=n.getDependency("bufferView",o.bufferView).then(function(f){return new Promise(function(p,g){t.parse(f,p,g)})});else{if(o.bufferView!==void 0)l=n.getDependency("bufferView",o.bufferView).then(function(f){c=!0;let p=new Blob([f],{type:o.mimeType});return l=a.createObjectURL(p),l});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");h=Promise.resolve(l).then(function(f){return new Promise(function(p,g){let y=p;t.isImageBitmapLoader===!0&&(y=function(m){let v=new an(m);v.needsUpdate=!0,p(v)}),t.load(Qi.resolveURL(f,r.path),y,void 0,g)})})}let u=h.then(function(f){return c===!0&&a.revokeObjectURL(l),Ai(f,o),f.userData.mimeType=o.mimeType||HM(o.uri),f}).catch(function(f){throw console.error("THREE.GLTFLoader: Couldn't load texture",l),f});return this.sourceCache[e]=u,u}assignTexture(e,t,n,s){let r=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),r.extensions[ot.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[ot.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let l=r.associations.get(o);o=r.extensions[ot.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),r.associations.set(o,l)}}return s!==void 0&&(o.colorSpace=s),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,s=t.attributes.tangent===void 0,r=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new Ar,In.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,l.sizeAttenuation=!1,this.cache.add(a,l)),n=l}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new Xi,In.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,this.cache.add(a,l)),n=l}if(s||r||o){let a="ClonedMaterial:"+n.uuid+":";s&&(a+="derivative-tangents:"),r&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let l=this.cache.get(a);l||(l=n.clone(),r&&(l.vertexColors=!0),o&&(l.flatShading=!0),s&&(l.normalScale&&(l.normalScale.y*=-1),l.clearcoatNormalScale&&(l.clearcoatNormalScale.y*=-1)),this.cache.add(a,l),this.associations.set(l,this.associations.get(n))),n=l}e.material=n}getMaterialType(){return ks}loadMaterial(e){let t=this,n=this.json,s=this.extensions,r=n.materials[e],o,a={},l=r.extensions||{},c=[];if(l[ot.KHR_MATERIALS_UNLIT]){let u=s[ot.KHR_MATERIALS_UNLIT];o=u.getMaterialType(),c.push(u.extendParams(a,r,t))}else{let u=r.pbrMetallicRoughness||{};if(a.color=new Xe(1,1,1),a.opacity=1,Array.isArray(u.baseColorFactor)){let f=u.baseColorFactor;a.color.setRGB(f[0],f[1],f[2],Ot),a.opacity=f[3]}u.baseColorTexture!==void 0&&c.push(t.assignTexture(a,"map",u.baseColorTexture,Xt)),a.metalness=u.metallicFactor!==void 0?u.metallicFactor:1,a.roughness=u.roughnessFactor!==void 0?u.roughnessFactor:1,u.metallicRoughnessTexture!==void 0&&(c.push(t.assignTexture(a,"metalnessMap",u.metallicRoughnessTexture)),c.push(t.assignTexture(a,"roughnessMap",u.metallicRoughnessTexture))),o=this._invokeOne(function(f){return f.getMaterialType&&f.getMaterialType(e)}),c.push(Promise.all(this._invokeAll(function(f){return f.extendMaterialParams&&f.extendMaterialParams(e,a)})))}r.doubleSided===!0&&(a.side=Ln);let h=r.alphaMode||Wu.OPAQUE;if(h===Wu.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,h===Wu.MASK&&(a.alphaTest=r.alphaCutoff!==void 0?r.alphaCutoff:.5)),r.normalTexture!==void 0&&o!==ii&&(c.push(t.assignTexture(a,"normalMap",r.normalTexture)),a.normalScale=new it(1,1),r.normalTexture.scale!==void 0)){let u=r.normalTexture.scale;a.normalScale.set(u,u)}if(r.occlusionTexture!==void 0&&o!==ii&&(c.push(t.assignTexture(a,"aoMap",r.occlusionTexture)),r.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=r.occlusionTexture.strength)),r.emissiveFactor!==void 0&&o!==ii){let u=r.emissiveFactor;a.emissive=new Xe().setRGB(u[0],u[1],u[2],Ot)}return r.emissiveTexture!==void 0&&o!==ii&&c.push(t.assignTexture(a,"emissiveMap",r.emissiveTexture,Xt)),Promise.all(c).then(function(){let u=new o(a);return r.name&&(u.name=r.name),Ai(u,r),t.associations.set(u,{materials:e}),r.extensions&&qs(s,u,r),u})}createUniqueName(e){let t=It.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,s=this.primitiveCache;function r(a){return n[ot.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(l){return $m(l,a,t)})}let o=[];for(let a=0,l=e.length;a<l;a++){let c=e[a],h=zM(c),u=s[h];if(u)o.push(u.promise);else{let f;c.extensions&&c.extensions[ot.KHR_DRACO_MESH_COMPRESSION]?f=r(c):f=$m(new Lt,c,t),c.mode===Kn.TRIANGLE_STRIP?f=f.then(p=>Gu(p,Ko)):c.mode===Kn.TRIANGLE_FAN&&(f=f.then(p=>Gu(p,Ur))),s[h]={primitive:c,promise:f},o.push(f)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,s=this.extensions,r=n.meshes[e],o=r.primitives,a=[];for(let l=0,c=o.length;l<c;l++){let h=o[l].material===void 0?OM(this.cache):this.getDependency("material",o[l].material);a.push(h)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(l){let c=l.slice(0,l.length-1),h=l[l.length-1],u=[];for(let p=0,g=h.length;p<g;p++){let y=h[p],m=o[p],v,A=c[p];if(m.mode===Kn.TRIANGLES||m.mode===Kn.TRIANGLE_STRIP||m.mode===Kn.TRIANGLE_FAN||m.mode===void 0){let S=r.isSkinnedMesh===!0,w=y.hasAttribute("skinIndex")&&y.hasAttribute("skinWeight");S&&w===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),v=S&&w?new So(y,A):new At(y,A),v.isSkinnedMesh===!0&&v.normalizeSkinWeights()}else if(m.mode===Kn.LINES)v=new To(y,A);else if(m.mode===Kn.LINE_STRIP)v=new yi(y,A);else if(m.mode===Kn.LINE_LOOP)v=new Bs(y,A);else if(m.mode===Kn.POINTS)v=new Eo(y,A);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+m.mode);Object.keys(v.geometry.morphAttributes).length>0&&kM(v,r),v.name=t.createUniqueName(r.name||"mesh_"+e),Ai(v,r),m.extensions&&qs(s,v,m),t.assignFinalMaterial(v),u.push(v)}for(let p=0,g=u.length;p<g;p++)t.associations.set(u[p],{meshes:e,primitives:p});if(u.length===1)return r.extensions&&qs(s,u[0],r),u[0];let f=new Bn;r.extensions&&qs(s,f,r),t.associations.set(f,{meshes:e});for(let p=0,g=u.length;p<g;p++)f.add(u[p]);return f})}loadCamera(e){let t,n=this.json.cameras[e],s=n[n.type];if(!s){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new Kt(bc.radToDeg(s.yfov),s.aspectRatio||1,s.znear||1,s.zfar||2e6):n.type==="orthographic"&&(t=new Gn(-s.xmag,s.xmag,s.ymag,-s.ymag,s.znear,s.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),Ai(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let s=0,r=t.joints.length;s<r;s++)n.push(this._loadNodeShallow(t.joints[s]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(s){let r=s.pop(),o=s,a=[],l=[];for(let c=0,h=o.length;c<h;c++){let u=o[c];if(u){a.push(u);let f=new et;r!==null&&f.fromArray(r.array,c*16),l.push(f)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[c])}return new wo(a,l)})}loadAnimation(e){let t=this.json,n=this,s=t.animations[e],r=s.name?s.name:"animation_"+e,o=[],a=[],l=[],c=[],h=[];for(let u=0,f=s.channels.length;u<f;u++){let p=s.channels[u],g=s.samplers[p.sampler],y=p.target,m=y.node,v=s.parameters!==void 0?s.parameters[g.input]:g.input,A=s.parameters!==void 0?s.parameters[g.output]:g.output;y.node!==void 0&&(o.push(this.getDependency("node",m)),a.push(this.getDependency("accessor",v)),l.push(this.getDependency("accessor",A)),c.push(g),h.push(y))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l),Promise.all(c),Promise.all(h)]).then(function(u){let f=u[0],p=u[1],g=u[2],y=u[3],m=u[4],v=[];for(let S=0,w=f.length;S<w;S++){let T=f[S],E=p[S],x=g[S],b=y[S],L=m[S];if(T===void 0)continue;T.updateMatrix&&T.updateMatrix();let I=n._createAnimationTracks(T,E,x,b,L);if(I)for(let F=0;F<I.length;F++)v.push(I[F])}let A=new No(r,void 0,v);return Ai(A,s),A})}createNodeMesh(e){let t=this.json,n=this,s=t.nodes[e];return s.mesh===void 0?null:n.getDependency("mesh",s.mesh).then(function(r){let o=n._getNodeRef(n.meshCache,s.mesh,r);return s.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let l=0,c=s.weights.length;l<c;l++)a.morphTargetInfluences[l]=s.weights[l]}),o})}loadNode(e){let t=this.json,n=this,s=t.nodes[e],r=n._loadNodeShallow(e),o=[],a=s.children||[];for(let c=0,h=a.length;c<h;c++)o.push(n.getDependency("node",a[c]));let l=s.skin===void 0?Promise.resolve(null):n.getDependency("skin",s.skin);return Promise.all([r,Promise.all(o),l]).then(function(c){let h=c[0],u=c[1],f=c[2];f!==null&&h.traverse(function(p){p.isSkinnedMesh&&p.bind(f,GM)});for(let p=0,g=u.length;p<g;p++)h.add(u[p]);if(h.userData.pivot!==void 0&&u.length>0){let p=h.userData.pivot,g=u[0];h.pivot=new $().fromArray(p),h.position.x-=p[0],h.position.y-=p[1],h.position.z-=p[2],g.position.set(0,0,0),delete h.userData.pivot}return h})}_loadNodeShallow(e){let t=this.json,n=this.extensions,s=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let r=t.nodes[e],o=r.name?s.createUniqueName(r.name):"",a=[],l=s._invokeOne(function(c){return c.createNodeMesh&&c.createNodeMesh(e)});return l&&a.push(l),r.camera!==void 0&&a.push(s.getDependency("camera",r.camera).then(function(c){return s._getNodeRef(s.cameraCache,r.camera,c)})),s._invokeAll(function(c){return c.createNodeAttachment&&c.createNodeAttachment(e)}).forEach(function(c){a.push(c)}),this.nodeCache[e]=Promise.all(a).then(function(c){let h;if(r.isBone===!0?h=new wr:c.length>1?h=new Bn:c.length===1?h=c[0]:h=new zt,h!==c[0])for(let u=0,f=c.length;u<f;u++)h.add(c[u]);if(r.name&&(h.userData.name=r.name,h.name=o),Ai(h,r),r.extensions&&qs(n,h,r),r.matrix!==void 0){let u=new et;u.fromArray(r.matrix),h.applyMatrix4(u)}else r.translation!==void 0&&h.position.fromArray(r.translation),r.rotation!==void 0&&h.quaternion.fromArray(r.rotation),r.scale!==void 0&&h.scale.fromArray(r.scale);if(!s.associations.has(h))s.associations.set(h,{});else if(r.mesh!==void 0&&s.meshCache.refs[r.mesh]>1){let u=s.associations.get(h);s.associations.set(h,{...u})}return s.associations.get(h).nodes=e,h}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],s=this,r=new Bn;n.name&&(r.name=s.createUniqueName(n.name)),Ai(r,n),n.extensions&&qs(t,r,n);let o=n.nodes||[],a=[];for(let l=0,c=o.length;l<c;l++)a.push(s.getDependency("node",o[l]));return Promise.all(a).then(function(l){for(let h=0,u=l.length;h<u;h++){let f=l[h];f.parent!==null?r.add(zm(f)):r.add(f)}let c=h=>{let u=new Map;for(let[f,p]of s.associations)(f instanceof In||f instanceof an)&&u.set(f,p);return h.traverse(f=>{let p=s.associations.get(f);p!=null&&u.set(f,p)}),u};return s.associations=c(r),r})}_createAnimationTracks(e,t,n,s,r){let o=[],a=e.name?e.name:e.uuid,l=[];function c(p){p.morphTargetInfluences&&l.push(p.name?p.name:p.uuid)}bs[r.path]===bs.weights?(c(e),e.isGroup&&e.children.forEach(c)):l.push(a);let h;switch(bs[r.path]){case bs.weights:h=Zi;break;case bs.rotation:h=Ki;break;case bs.translation:case bs.scale:h=xs;break;default:n.itemSize===1?h=Zi:h=xs;break}let u=s.interpolation!==void 0?UM[s.interpolation]:Ns,f=this._getArrayFromAccessor(n);for(let p=0,g=l.length;p<g;p++){let y=new h(l[p]+"."+bs[r.path],t.array,f,u);s.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(y),o.push(y)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=vf(t.constructor),s=new Float32Array(t.length);for(let r=0,o=t.length;r<o;r++)s[r]=t[r]*n;t=s}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let s=this instanceof Ki?mf:Pc;return new s(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function VM(i,e,t){let n=e.attributes,s=new zn;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],l=a.min,c=a.max;if(l!==void 0&&c!==void 0){if(s.set(new $(l[0],l[1],l[2]),new $(c[0],c[1],c[2])),a.normalized){let h=vf(kr[a.componentType]);s.min.multiplyScalar(h),s.max.multiplyScalar(h)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let r=e.targets;if(r!==void 0){let a=new $,l=new $;for(let c=0,h=r.length;c<h;c++){let u=r[c];if(u.POSITION!==void 0){let f=t.json.accessors[u.POSITION],p=f.min,g=f.max;if(p!==void 0&&g!==void 0){if(l.setX(Math.max(Math.abs(p[0]),Math.abs(g[0]))),l.setY(Math.max(Math.abs(p[1]),Math.abs(g[1]))),l.setZ(Math.max(Math.abs(p[2]),Math.abs(g[2]))),f.normalized){let y=vf(kr[f.componentType]);l.multiplyScalar(y)}a.max(l)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}s.expandByVector(a)}i.boundingBox=s;let o=new Cn;s.getCenter(o.center),o.radius=s.min.distanceTo(s.max)/2,i.boundingSphere=o}function $m(i,e,t){let n=e.attributes,s=[];function r(o,a){return t.getDependency("accessor",o).then(function(l){i.setAttribute(a,l)})}for(let o in n){let a=gf[o]||o.toLowerCase();a in i.attributes||s.push(r(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});s.push(o)}return rt.workingColorSpace!==Ot&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${rt.workingColorSpace}" not supported.`),Ai(i,e),VM(i,e,t),Promise.all(s).then(function(){return e.targets!==void 0?BM(i,e.targets,t):i})}var qm=Math.tan(15*Math.PI/180),WM=14,Ym=.02;function Zm(i,e,t,n){let s=$M(i,t),r=i.length/3,o=new Float32Array(r),a=n.length-1;for(let l=0;l<r;l+=1){let c=Math.min(Math.max(e[3*l+1],-1),1),h=Math.acos(c)/Math.PI*a,u=Math.min(Math.floor(h),a-1),f=n[u]+(h-u)*(n[u+1]-n[u]);o[l]=f>0?f*s.open(i[3*l],i[3*l+1],i[3*l+2],c):0}return o}function $M(i,e){let[t,n,s,r]=[1/0,1/0,-1/0,-1/0];for(let h=0;h<i.length;h+=3)t=Math.min(t,i[h]),s=Math.max(s,i[h]),n=Math.min(n,i[h+2]),r=Math.max(r,i[h+2]);let o=Math.max(s-t,r-n,1e-9)/191,a=new Float32Array(36864).fill(-1/0),l=h=>(h-t)/o,c=h=>(h-n)/o;for(let h=0;h<e.length;h+=3){let[u,f,p]=[3*e[h],3*e[h+1],3*e[h+2]],[g,y,m,v,A,S]=[l(i[u]),c(i[u+2]),l(i[f]),c(i[f+2]),l(i[p]),c(i[p+2])],w=(m-g)*(S-y)-(A-g)*(v-y);for(let T=Math.max(Math.ceil(Math.min(y,v,S)),0);T<=Math.min(Math.floor(Math.max(y,v,S)),191);T+=1)for(let E=Math.max(Math.ceil(Math.min(g,m,A)),0);E<=Math.min(Math.floor(Math.max(g,m,A)),191);E+=1){let x=((E-g)*(S-y)-(A-g)*(T-y))/w,b=((m-g)*(T-y)-(E-g)*(v-y))/w;if(!(x>=-1e-6&&b>=-1e-6&&x+b<=1+1e-6))continue;let L=i[u+1]+x*(i[f+1]-i[u+1])+b*(i[p+1]-i[u+1]);L>a[T*192+E]&&(a[T*192+E]=L)}}return{open(h,u,f,p){let g=u+Ym+1.5*o*Math.min(Math.sqrt(Math.max(1-p*p,0))/Math.max(p,.1),8),y=0;for(let m=0;m<9;m+=1){let[v,A]=m===8?[0,0]:[Math.cos(m*Math.PI/4)*qm,Math.sin(m*Math.PI/4)*qm],S=!1;for(let w=0;w<WM&&!S;w+=1){let T=Ym+.015*(w*w+w),E=Math.round(c(f+A*T)),x=Math.round(l(h+v*T));if(E<0||x<0||E>=192||x>=192)break;S=a[E*192+x]>g+T}S||(y+=1)}return y/9}}}var Km=2.3,na=5e6;function Jm(i){let e=new Uint16Array(Ni(i.positions)),t=Float32Array.from(e,(a,l)=>i.low[l%3]+(i.high[l%3]-i.low[l%3])*a/65535),n=Float32Array.from(new Int16Array(Ni(i.normals)),a=>a/32767),s=Float32Array.from(new Uint8Array(Ni(i.dust)),a=>a/255),r=i.high.map((a,l)=>a-i.low[l]),o=Math.min(1,Km/Math.max(...r));for(let a=0;a<t.length;a+=1)t[a]=(t[a]-i.low[a%3]-r[a%3]/2)*o;return jm(t,n,new Uint16Array(Ni(i.triangles)),s)}function yf(i,e,t){let n=t==="z"?XM(i):i,{positions:s,indices:r}=n;if(r.length<3)throw new oe(`${n.name} has no triangle`,"Export the mesh with its faces");if(r.length/3>na)throw new oe(`${n.name} has ${(r.length/3).toLocaleString("en")} triangles, more than ${na.toLocaleString("en")}`,"Decimate it");let o=s.length/3;for(let y of r)if(y>=o)throw new oe(`${n.name} has a face with vertex ${y} of ${o} vertices`,"The file is damaged");let a=[1/0,1/0,1/0],l=[-1/0,-1/0,-1/0];for(let y of r)for(let m=0;m<3;m+=1){let v=s[3*y+m];if(!Number.isFinite(v))throw new oe(`${n.name} has a vertex whose position is not finite`,"Export it again; a modifier that divides by zero is a usual cause");a[m]=Math.min(a[m],v),l[m]=Math.max(l[m],v)}let c=Math.max(...a.map((y,m)=>l[m]-y));if(!(c>0))throw new oe(`${n.name} has no extent: all its vertices lie in one point`,"Export it again");let h=new Float32Array(s.length);for(let y=0;y<s.length;y+=1)h[y]=(s[y]-(a[y%3]+l[y%3])/2)/c*Km;let u=jm(h,n.normals&&qM(n.normals,o)?n.normals:null,o<65536?Uint16Array.from(r):r,null);u.getAttribute("normal")||u.computeVertexNormals();let f=u.getAttribute("normal").array,p=xf(n),g=n.tau&&p>0?n.tau.map(y=>y/p):Zm(h,f,r,e);return u.setAttribute("dust",new ut(g,1)),u}function xf(i){let e=0;for(let t of i.tau??[]){if(!(t>=0&&Number.isFinite(t)))throw new oe(`${i.name} has a vertex with tau = ${t}, which is no optical thickness`,"tau is a number from 0 on");e=Math.max(e,t)}return e}function XM(i){let e=t=>t.map((n,s)=>s%3===0?n:s%3===1?t[s+1]:-t[s-1]);return{...i,positions:e(i.positions),normals:i.normals&&e(i.normals)}}function qM(i,e){if(i.length!==3*e)return!1;for(let t=0;t<i.length;t+=3)if(!(Math.hypot(i[t],i[t+1],i[t+2])>1e-6))return!1;return!0}function jm(i,e,t,n){let s=new Lt;return s.setAttribute("position",new ut(i,3)),e&&s.setAttribute("normal",new ut(e,3)),n&&s.setAttribute("dust",new ut(n,1)),s.setIndex(new ut(t,1)),s}var tg=1179937895,ng=1313821514,ig=5130562,YM={5120:1,5121:1,5122:2,5123:2,5125:4,5126:4},ZM={SCALAR:1,VEC2:2,VEC3:3,VEC4:4},Qm=64,KM=252,Lc="KHR_mesh_quantization";async function sg(i,e){let{document:t,binary:n}=jM(i,e),s=tS(QM(i,t,n.byteLength),n),{scene:r}=await new Cc().parseAsync(s,"");r.updateMatrixWorld(!0);let o=[];return r.traverse(a=>{a instanceof At&&o.push(a)}),JM(i,o)}function JM(i,e){let t=e.map(({geometry:h})=>[h.getAttribute("position").count,h.getIndex()?.count??h.getAttribute("position").count]),n=new Float32Array(3*t.reduce((h,[u])=>h+u,0)),s=new Uint32Array(t.reduce((h,[,u])=>h+u,0)),o=e.length>0&&e.every(({geometry:h})=>h.getAttribute("normal"))?new Float32Array(n.length):null,a=new $,[l,c]=[0,0];return e.forEach(({geometry:h,matrixWorld:u},f)=>{let p=new Je().getNormalMatrix(u),g=u.determinant()<0,[y,m,v]=[h.getAttribute("position"),h.getAttribute("normal"),h.getIndex()];for(let S=0;S<y.count;S+=1)eg(a,y,S).applyMatrix4(u).toArray(n,3*(l+S)),o&&eg(a,m,S).applyMatrix3(p).normalize().toArray(o,3*(l+S));let A=t[f][1];for(let S=0;S<A;S+=1){let w=g?S-S%3+(3-S%3)%3:S;s[c+S]=l+(v?v.getX(w):w)}l+=y.count,c+=A}),{name:i,positions:n,normals:o,indices:s}}function eg(i,e,t){return i.fromBufferAttribute(e,t)}function jM(i,e){let t=new DataView(e);if(e.byteLength<20||t.getUint32(0,!0)!==tg||t.getUint32(4,!0)!==2)throw new oe(`${i} is not a GLB file of version 2`,"Export it as glTF binary (.glb)");let n=null,s=new Uint8Array(0);for(let r=12;r+8<=e.byteLength;){let[o,a]=[t.getUint32(r,!0),t.getUint32(r+4,!0)];if(r+8+o>e.byteLength)throw new oe(`${i} is cut short`,"Export it again");let l=new Uint8Array(e,r+8,o);a===ng&&n===null&&(n=JSON.parse(new TextDecoder().decode(l))),a===ig&&!s.length&&(s=l),r+=8+o}if(!ln(n))throw new oe(`${i} has no description`,"Export it again");return{document:n,binary:s}}function QM(i,e,t){let n=b=>new oe(`${i} has ${b} that lead nowhere, or beyond the file`,"The file is damaged; export it again"),s=(b,L)=>{let I=b[L]??[];if(!Array.isArray(I)||!I.every(ln))throw n(L);return I},r=(b,L,I=0)=>{let F=b[L]??I;if(typeof F!="number"||!Number.isSafeInteger(F)||F<0)throw new oe(`${i}: ${L} = ${Ut(F)} is no size`,"The file is damaged; export it again");return F},o=(b,L,I)=>{if(typeof b!="number"||!Number.isInteger(b)||b<0||b>=L)throw n(I);return b},a=Array.isArray(e.extensionsRequired)?e.extensionsRequired.map(String):[],l=a.filter(b=>b!==Lc&&!/^KHR_(materials|texture|lights)/.test(b));if(l.length)throw new oe(`${i} is compressed, or needs ${l.join(", ").slice(0,80)}`,"Export it without compression or extensions");let[c,...h]=s(e,"buffers");if(!c||h.length||c.uri!==void 0)throw new oe(`${i} keeps its numbers in other files`,"Export it as glTF binary (.glb), in one file");if(r(c,"byteLength")>t)throw new oe(`${i} is cut short: it claims ${r(c,"byteLength")} bytes of numbers and has ${t}`,"Export it again");let u=s(e,"bufferViews").map(b=>{let[L,I,F]=[r(b,"byteOffset"),r(b,"byteLength"),r(b,"byteStride")];if(o(b.buffer,1,"bufferViews")!==0||L+I>t||F>KM)throw n("bufferViews");return{buffer:0,byteOffset:L,byteLength:I,...F?{byteStride:F}:{}}}),f=s(e,"accessors").map(b=>{let L=(YM[Number(b.componentType)]??0)*(ZM[String(b.type)]??0);if(!L||b.sparse!==void 0||b.bufferView===void 0)return null;let[I,F]=[r(b,"count"),r(b,"byteOffset")],B=o(b.bufferView,u.length,"accessors"),{byteLength:z,byteStride:D}=u[B];if(I&&F+(I-1)*(D??L)+L>z||D!==void 0&&D<L)throw n("accessors");let W=b.type==="VEC3"?{min:[0,0,0],max:[0,0,0]}:{};return{bufferView:B,byteOffset:F,count:I,componentType:Number(b.componentType),type:String(b.type),normalized:b.normalized===!0,...W}}),p=b=>{let L=o(b,f.length,"meshes");if(!f[L])throw new oe(`${i} holds numbers in a way that is not supported`,"Export it again without sparse accessors");return L},g=[],y=s(e,"meshes").map(b=>{let L=0,I=s(b,"primitives").flatMap(F=>{let[B,z]=[r(F,"mode",4),F.attributes];if(![4,5,6].includes(B)||!ln(z)||z.POSITION===void 0)return[];let D=p(z.POSITION),W=z.NORMAL===void 0?void 0:p(z.NORMAL),q=F.indices===void 0?void 0:p(F.indices);if(f[D].type!=="VEC3"||W!==void 0&&(f[W].type!=="VEC3"||f[W].count!==f[D].count)||q!==void 0&&(f[q].type!=="SCALAR"||![5121,5123,5125].includes(f[q].componentType)))throw n("meshes");let K=f[q??D].count;return L+=B===4?K/3:K,K<3?[]:[{mode:B,attributes:{POSITION:D,...W===void 0?{}:{NORMAL:W}},...q===void 0?{}:{indices:q}}]});return g.push(L),{primitives:I}}),m=s(e,"nodes"),v=new Map,A=0,S=m.map((b,L)=>{let I=b.children??[];if(!Array.isArray(I))throw n("nodes");for(let z of I){if(v.has(o(z,m.length,"nodes")))throw n("nodes");v.set(z,L)}let F=b.mesh===void 0?void 0:o(b.mesh,y.length,"nodes");A+=F===void 0?0:g[F];let B=F!==void 0&&y[F].primitives.length>0;return{...eS(b),...I.length?{children:I}:{},...B?{mesh:F}:{}}});for(let b=0;b<m.length;b+=1){let L=0;for(let I=v.get(b);I!==void 0;I=v.get(I))if((L+=1)>Qm)throw new oe(`${i} has nodes that are their own ancestors, or more than ${Qm} deep`,"Export it again")}if(A>na)throw new oe(`${i} has ${Math.round(A).toLocaleString("en")} triangles, more than ${na.toLocaleString("en")}`,"Decimate it");let w=s(e,"scenes"),E=(w.length?w[o(e.scene??0,w.length,"scenes")]:{nodes:m.map((b,L)=>L).filter(b=>!v.has(b))}).nodes??[];if(!Array.isArray(E))throw n("scenes");for(let b of E)o(b,m.length,"scenes");let x=[...new Set(E)];return{asset:{version:"2.0"},...a.includes(Lc)?{extensionsUsed:[Lc],extensionsRequired:[Lc]}:{},scene:0,scenes:[{nodes:x.filter(b=>!v.has(b))}],nodes:S,meshes:y.map(b=>b.primitives.length?b:{primitives:[{attributes:{}}]}),accessors:f.map(b=>b??{count:0,componentType:5126,type:"SCALAR"}),bufferViews:u,buffers:[{byteLength:t}]}}function eS(i){let e={};for(let[t,n]of[["matrix",16],["translation",3],["rotation",4],["scale",3]]){let s=i[t];Array.isArray(s)&&s.length===n&&s.every(r=>typeof r=="number"&&Number.isFinite(r))&&(e[t]=s)}return e}function tS(i,e){let t=new TextEncoder().encode(JSON.stringify(i)),[n,s]=[Math.ceil(t.length/4)*4,Math.ceil(e.length/4)*4],r=new Uint8Array(28+n+s).fill(32,20,20+n),o=new DataView(r.buffer);return[tg,2,r.length,n,ng].forEach((a,l)=>o.setUint32(4*l,a,!0)),r.set(t,20),o.setUint32(20+n,s,!0),o.setUint32(24+n,ig,!0),r.set(e,28+n),r.buffer}var lg=[".obj",".ply",".glb"],rg=400*2**20,nS=65536;async function cg(i,e){if(e.byteLength>rg)throw new oe(`${i} has ${Math.round(e.byteLength/2**20)} MiB, more than ${rg/2**20}`,"Decimate it");let t=i.slice(i.lastIndexOf(".")).toLowerCase();try{return t===".obj"?iS(i,new TextDecoder().decode(e)):t===".ply"?oS(i,e):await sg(i,e)}catch(n){throw n instanceof oe?n:new oe(`${i} is not a mesh that can be read: ${n instanceof Error?n.message:String(n)}`,"Export it again as OBJ, PLY or GLB")}}function iS(i,e){let t=[],n=[],s=[],r=[],o=0;for(let p=0;p<e.length;){let g=e.indexOf(`
`,p);g<0&&(g=e.length),o+=1;let y=e.charCodeAt(p);for(let m=p;(y===32||y===9)&&m<g;m+=1)y=e.charCodeAt(m+1);if(y===118||y===102){let m=e.slice(p,g);for(;/\\\s*$/.test(m)&&g<e.length;){let A=e.indexOf(`
`,g+1);m=m.replace(/\\\s*$/," ")+e.slice(g+1,A<0?e.length:A),g=A<0?e.length:A,o+=1}let v=m.replace(/#.*/,"").trim().split(/\s+/);if(v[0]==="v")t.push(...og(v,i,o));else if(v[0]==="vn")n.push(...og(v,i,o));else if(v[0]==="f"){let A=v.slice(1).map(S=>sS(S,t.length/3,n.length/3,i,o));if(A.length<3)throw new oe(`${i}, line ${o}: a face with ${A.length} corners`,"Export it again");for(let S=1;S+1<A.length;S+=1)for(let[w,T]of[A[0],A[S],A[S+1]])s.push(w),r.push(T)}}p=g+1}let a=Float32Array.from(t);if(!n.length||r.some(p=>p<0))return{name:i,positions:a,normals:null,indices:Uint32Array.from(s)};let l=new Map,c=new Uint32Array(s.length),[h,u]=[[],[]],f=n.length/3;return s.forEach((p,g)=>{let y=p*f+r[g],m=l.get(y);if(m===void 0){m=l.size,l.set(y,m);for(let v=0;v<3;v+=1)h.push(t[3*p+v]),u.push(n[3*r[g]+v])}c[g]=m}),{name:i,positions:Float32Array.from(h),normals:Float32Array.from(u),indices:c}}function og(i,e,t){let[n,s,r]=[Number(i[1]),Number(i[2]),Number(i[3])];if(![n,s,r].every(Number.isFinite))throw new oe(`${e}, line ${t}: ${i.slice(0,4).join(" ").slice(0,60)} is not three numbers`,"Export it again");return[n,s,r]}function sS(i,e,t,n,s){let[r,,o]=i.split("/"),a=(c,h)=>{if(!c)return-1;let u=Number(c),f=u<0?h+u:u-1;if(!Number.isInteger(u)||f<0||f>=h)throw new oe(`${n}, line ${s}: ${i.slice(0,40)} is not among ${h} vertices`,"The file is damaged");return f},l=a(r,e);if(l<0)throw new oe(`${n}, line ${s}: a corner without a vertex`,"The file is damaged");return[l,a(o,t)]}var ag=["vertex_indices","vertex_index"];function rS(i,e,t){let n=[];for(let a of e.split(/\r\n|\r|\n/)){let l=a.trim().split(/\s+/);if(l[0]==="element"&&n.push({name:l[1]??"",count:Number(l[2]),properties:[]}),l[0]!=="property")continue;if(n.at(-1)?.properties.push(l),(l[1]==="list"?[l[2],ag.includes(l[4]??"")?l[3]:void 0]:[]).some(h=>h&&/^(float|double)/.test(h)))throw new oe(`${i} has faces whose vertices are fractions: ${Ut(a.trim())}`,"Export it again")}if(!/^\s*format\s+ascii\b/m.test(e))return;let s=new TextDecoder("latin1").decode(t),r=s.slice(s.indexOf("end_header")+10).split(/\r\n|\r|\n/).filter(a=>a.trim()),o=0;for(let a of n){let l=r.slice(o,o+=a.count);if(a.name==="face")for(let c of l){let h=c.trim().split(/\s+/),u=0;for(let f of a.properties){if(f[1]!=="list"){u+=1;continue}let p=Number(h[u]),g=ag.includes(f[4]??"")?h.slice(u,u+1+p):[h[u]];if(h.length<u+1+p)throw new oe(`${i} breaks off within the face ${Ut(c.trim())}`,"The file is damaged; fetch it again");if(!g.every(y=>/^[+-]?\d+$/.test(y)))throw new oe(`${i} has the face ${Ut(c.trim())}, whose vertices are not whole numbers`,"Export it again");u+=1+p}}}}function oS(i,e){if(new TextDecoder("latin1").decode(e.slice(0,3))!=="ply")throw new oe(`${i} does not begin with "ply"`,"Export it again");let t=new TextDecoder("latin1").decode(e.slice(0,nS)).split("end_header")[0];for(let[,h,u]of t.matchAll(/^\s*element\s+(\S+)\s+(\S+)/gm))if(!(Number(u)<=e.byteLength))throw new oe(`${i} claims ${Ut(u)} of ${Ut(h)}, more than its ${e.byteLength} bytes hold`,"The file is damaged");rS(i,t,e);let n=new Rc,s=/^\s*property\s+\w+\s+tau\s*$/m.test((/element\s+vertex\b[^]*?(?=^\s*element\b|$(?![^]))/m.exec(t)??[""])[0]);s&&n.setCustomPropertyNameMapping({tau:["tau"]});let r=n.parse(e);!r.getIndex()&&/^\s*element\s+face\s+0*[1-9]/m.test(t)&&(r.getAttribute("color")||r.getAttribute("uv"))&&(r=aS(r));let o=r.getAttribute("position")?.array,a=r.getIndex()?.array;if(!o||!a)throw new oe(`${i} has no faces`,"Export the mesh with its faces; clouds of points cannot be shaded");let l=r.getAttribute("normal")?.array,c=s?r.getAttribute("tau")?.array:null;return{name:i,positions:Float32Array.from(o),normals:l?Float32Array.from(l):null,indices:Uint32Array.from(a),tau:c?Float32Array.from(c):null}}function aS(i){for(let e of Object.keys(i.attributes))["position","normal","tau"].includes(e)||i.deleteAttribute(e);return km(i,0)}var Jn=Uint8Array,zr=Uint16Array,lS=Int32Array,hg=new Jn([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),ug=new Jn([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),cS=new Jn([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),fg=function(i,e){for(var t=new zr(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new lS(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},dg=fg(hg,2),pg=dg.b,hS=dg.r;pg[28]=258,hS[258]=28;var mg=fg(ug,0),uS=mg.b,$E=mg.r,Sf=new zr(32768);for(xt=0;xt<32768;++xt)is=(xt&43690)>>1|(xt&21845)<<1,is=(is&52428)>>2|(is&13107)<<2,is=(is&61680)>>4|(is&3855)<<4,Sf[xt]=((is&65280)>>8|(is&255)<<8)>>1;var is,xt,ia=(function(i,e,t){for(var n=i.length,s=0,r=new zr(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new zr(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new zr(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],h=e-i[s],u=o[i[s]-1]++<<h,f=u|(1<<h)-1;u<=f;++u)a[Sf[u]>>l]=c}else for(a=new zr(n),s=0;s<n;++s)i[s]&&(a[s]=Sf[o[i[s]-1]++]>>15-i[s]);return a}),sa=new Jn(288);for(xt=0;xt<144;++xt)sa[xt]=8;var xt;for(xt=144;xt<256;++xt)sa[xt]=9;var xt;for(xt=256;xt<280;++xt)sa[xt]=7;var xt;for(xt=280;xt<288;++xt)sa[xt]=8;var xt,gg=new Jn(32);for(xt=0;xt<32;++xt)gg[xt]=5;var xt;var fS=ia(sa,9,1);var dS=ia(gg,5,1),bf=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},ai=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},Mf=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},pS=function(i){return(i+7)/8|0},mS=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new Jn(i.subarray(e,t))};var gS=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],li=function(i,e,t){var n=new Error(e||gS[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,li),!t)throw n;return n},vS=function(i,e,t,n){var s=i.length,r=n?n.length:0;if(!s||e.f&&!e.l)return t||new Jn(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new Jn(s*3));var c=function(Ve){var ft=t.length;if(Ve>ft){var mt=new Jn(Math.max(ft*2,Ve));mt.set(t),t=mt}},h=e.f||0,u=e.p||0,f=e.b||0,p=e.l,g=e.d,y=e.m,m=e.n,v=s*8;do{if(!p){h=ai(i,u,1);var A=ai(i,u+1,3);if(u+=3,A)if(A==1)p=fS,g=dS,y=9,m=5;else if(A==2){var E=ai(i,u,31)+257,x=ai(i,u+10,15)+4,b=E+ai(i,u+5,31)+1;u+=14;for(var L=new Jn(b),I=new Jn(19),F=0;F<x;++F)I[cS[F]]=ai(i,u+F*3,7);u+=x*3;for(var B=bf(I),z=(1<<B)-1,D=ia(I,B,1),F=0;F<b;){var W=D[ai(i,u,z)];u+=W&15;var S=W>>4;if(S<16)L[F++]=S;else{var q=0,K=0;for(S==16?(K=3+ai(i,u,3),u+=2,q=L[F-1]):S==17?(K=3+ai(i,u,7),u+=3):S==18&&(K=11+ai(i,u,127),u+=7);K--;)L[F++]=q}}var fe=L.subarray(0,E),J=L.subarray(E);y=bf(fe),m=bf(J),p=ia(fe,y,1),g=ia(J,m,1)}else li(1);else{var S=pS(u)+4,w=i[S-4]|i[S-3]<<8,T=S+w;if(T>s){l&&li(0);break}a&&c(f+w),t.set(i.subarray(S,T),f),e.b=f+=w,e.p=u=T*8,e.f=h;continue}if(u>v){l&&li(0);break}}a&&c(f+131072);for(var ae=(1<<y)-1,ce=(1<<m)-1,we=u;;we=u){var q=p[Mf(i,u)&ae],De=q>>4;if(u+=q&15,u>v){l&&li(0);break}if(q||li(2),De<256)t[f++]=De;else if(De==256){we=u,p=null;break}else{var ie=De-254;if(De>264){var F=De-257,Re=hg[F];ie=ai(i,u,(1<<Re)-1)+pg[F],u+=Re}var Ue=g[Mf(i,u)&ce],ze=Ue>>4;Ue||li(3),u+=Ue&15;var J=uS[ze];if(ze>3){var Re=ug[ze];J+=Mf(i,u)&(1<<Re)-1,u+=Re}if(u>v){l&&li(0);break}a&&c(f+131072);var me=f+ie;if(f<J){var $e=r-J,Mt=Math.min(J,me);for($e+f<0&&li(3);f<Mt;++f)t[f]=n[$e+f]}for(;f<me;++f)t[f]=t[f-J]}}e.l=p,e.p=we,e.b=f,e.f=h,p&&(h=1,e.m=y,e.d=g,e.n=m)}while(!h);return f!=t.length&&o?mS(t,0,f):t.subarray(0,f)};var _S=new Jn(0);var yS=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&li(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&li(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function Hr(i,e){return vS(i.subarray(yS(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var xS=typeof TextDecoder<"u"&&new TextDecoder,bS=0;try{xS.decode(_S,{stream:!0}),bS=1}catch{}var Nc=class extends zs{constructor(e){super(e),this.type=Jt,this.outputFormat=yt,this.part=0}parse(e){let L=Math.pow(2.7182818,2.2),I=null,F=null;function B(_,d){let M=0;for(let P=0;P<65536;++P)(P==0||_[P>>3]&1<<(P&7))&&(d[M++]=P);let C=M-1;for(;M<65536;)d[M++]=0;return C}function z(_){for(let d=0;d<16384;d++)_[d]={},_[d].len=0,_[d].lit=0,_[d].p=null}let D={l:0,c:0,lc:0};function W(_,d,M,C,P){for(;M<_;)d=d<<8|Me(C,P),M+=8;M-=_,D.l=d>>M&(1<<_)-1,D.c=d,D.lc=M}let q=new Array(59);function K(_){for(let M=0;M<=58;++M)q[M]=0;for(let M=0;M<65537;++M)q[_[M]]+=1;let d=0;for(let M=58;M>0;--M){let C=d+q[M]>>1;q[M]=d,d=C}for(let M=0;M<65537;++M){let C=_[M];C>0&&(_[M]=C|q[C]++<<6)}}function fe(_,d,M,C,P,U){let N=d,X=0,H=0;for(;C<=P;C++){if(N.value-d.value>M)return!1;W(6,X,H,_,N);let G=D.l;if(X=D.c,H=D.lc,U[C]=G,G==63){if(N.value-d.value>M)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");W(8,X,H,_,N);let Y=D.l+6;if(X=D.c,H=D.lc,C+Y>P+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;Y--;)U[C++]=0;C--}else if(G>=59){let Y=G-59+2;if(C+Y>P+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;Y--;)U[C++]=0;C--}}K(U)}function J(_){return _&63}function ae(_){return _>>6}function ce(_,d,M,C){for(;d<=M;d++){let P=ae(_[d]),U=J(_[d]);if(P>>U)throw new Error("THREE.EXRLoader: Invalid table entry");if(U>14){let N=C[P>>U-14];if(N.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(N.lit++,N.p){let X=N.p;N.p=new Array(N.lit);for(let H=0;H<N.lit-1;++H)N.p[H]=X[H]}else N.p=new Array(1);N.p[N.lit-1]=d}else if(U){let N=0;for(let X=1<<14-U;X>0;X--){let H=C[(P<<14-U)+N];if(H.len||H.p)throw new Error("THREE.EXRLoader: Invalid table entry");H.len=U,H.lit=d,N++}}}return!0}let we={c:0,lc:0};function De(_,d,M,C){_=_<<8|Me(M,C),d+=8,we.c=_,we.lc=d}let ie={c:0,lc:0};function Re(_,d,M,C,P,U,N,X,H){if(_==d){C<8&&(De(M,C,P,U),M=we.c,C=we.lc),C-=8;let G=M>>C;if(G=new Uint8Array([G])[0],X.value+G>H)return!1;let Y=N[X.value-1];for(;G-- >0;)N[X.value++]=Y}else if(X.value<H)N[X.value++]=_;else return!1;ie.c=M,ie.lc=C}function Ue(_){return _&65535}function ze(_){let d=Ue(_);return d>32767?d-65536:d}let me={a:0,b:0};function $e(_,d){let M=ze(_),P=ze(d),U=M+(P&1)+(P>>1),N=U,X=U-P;me.a=N,me.b=X}function Mt(_,d){let M=Ue(_),C=Ue(d),P=M-(C>>1)&65535,U=C+P-32768&65535;me.a=U,me.b=P}function Ve(_,d,M,C,P,U,N){let X=N<16384,H=M>P?P:M,G=1,Y,re;for(;G<=H;)G<<=1;for(G>>=1,Y=G,G>>=1;G>=1;){re=0;let Q=re+U*(P-Y),ee=U*G,ue=U*Y,de=C*G,pe=C*Y,Te,We,he,Ye;for(;re<=Q;re+=ue){let ye=re,Pe=re+C*(M-Y);for(;ye<=Pe;ye+=pe){let Ne=ye+de,gt=ye+ee,nt=gt+de;X?($e(_[ye+d],_[gt+d]),Te=me.a,he=me.b,$e(_[Ne+d],_[nt+d]),We=me.a,Ye=me.b,$e(Te,We),_[ye+d]=me.a,_[Ne+d]=me.b,$e(he,Ye),_[gt+d]=me.a,_[nt+d]=me.b):(Mt(_[ye+d],_[gt+d]),Te=me.a,he=me.b,Mt(_[Ne+d],_[nt+d]),We=me.a,Ye=me.b,Mt(Te,We),_[ye+d]=me.a,_[Ne+d]=me.b,Mt(he,Ye),_[gt+d]=me.a,_[nt+d]=me.b)}if(M&G){let Ne=ye+ee;X?$e(_[ye+d],_[Ne+d]):Mt(_[ye+d],_[Ne+d]),Te=me.a,_[Ne+d]=me.b,_[ye+d]=Te}}if(P&G){let ye=re,Pe=re+C*(M-Y);for(;ye<=Pe;ye+=pe){let Ne=ye+de;X?$e(_[ye+d],_[Ne+d]):Mt(_[ye+d],_[Ne+d]),Te=me.a,_[Ne+d]=me.b,_[ye+d]=Te}}Y=G,G>>=1}return re}function ft(_,d,M,C,P,U,N,X,H){let G=0,Y=0,re=N,Q=Math.trunc(C.value+(P+7)/8);for(;C.value<Q;)for(De(G,Y,M,C),G=we.c,Y=we.lc;Y>=14;){let ue=G>>Y-14&16383,de=d[ue];if(de.len)Y-=de.len,Re(de.lit,U,G,Y,M,C,X,H,re),G=ie.c,Y=ie.lc;else{if(!de.p)throw new Error("THREE.EXRLoader: hufDecode issues");let pe;for(pe=0;pe<de.lit;pe++){let Te=J(_[de.p[pe]]);for(;Y<Te&&C.value<Q;)De(G,Y,M,C),G=we.c,Y=we.lc;if(Y>=Te&&ae(_[de.p[pe]])==(G>>Y-Te&(1<<Te)-1)){Y-=Te,Re(de.p[pe],U,G,Y,M,C,X,H,re),G=ie.c,Y=ie.lc;break}}if(pe==de.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let ee=8-P&7;for(G>>=ee,Y-=ee;Y>0;){let ue=d[G<<14-Y&16383];if(ue.len)Y-=ue.len,Re(ue.lit,U,G,Y,M,C,X,H,re),G=ie.c,Y=ie.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function mt(_,d,M,C,P,U){let N={value:0},X=M.value,H=se(d,M),G=se(d,M);M.value+=4;let Y=se(d,M);if(M.value+=4,H<0||H>=65537||G<0||G>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let re=new Array(65537),Q=new Array(16384);z(Q);let ee=C-(M.value-X);if(fe(_,M,ee,H,G,re),Y>8*(C-(M.value-X)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");ce(re,H,G,Q),ft(re,Q,_,M,Y,G,U,P,N)}function at(_,d,M){for(let C=0;C<M;++C)d[C]=_[d[C]]}function Vt(_){for(let d=1;d<_.length;d++){let M=_[d-1]+_[d]-128;_[d]=M}}function Bt(_,d){let M=0,C=Math.floor((_.length+1)/2),P=0,U=_.length-1;for(;!(P>U||(d[P++]=_[M++],P>U));)d[P++]=_[C++]}function sn(_){let d=_.byteLength,M=new Array,C=0,P=new DataView(_);for(;d>0;){let U=P.getInt8(C++);if(U<0){let N=-U;d-=N+1;for(let X=0;X<N;X++)M.push(P.getUint8(C++))}else{let N=U;d-=2;let X=P.getUint8(C++);for(let H=0;H<N+1;H++)M.push(X)}}return M}function Dt(_,d,M,C,P,U){let N=new DataView(U.buffer),X=M[_.idx[0]].width,H=M[_.idx[0]].height,G=3,Y=Math.floor(X/8),re=Math.ceil(X/8),Q=Math.ceil(H/8),ee=X-(re-1)*8,ue=H-(Q-1)*8,de={value:0},pe=new Array(G),Te=new Array(G),We=new Array(G),he=new Array(G),Ye=new Array(G);for(let Pe=0;Pe<G;++Pe)Ye[Pe]=d[_.idx[Pe]],pe[Pe]=Pe<1?0:pe[Pe-1]+re*Q,Te[Pe]=new Float32Array(64),We[Pe]=new Uint16Array(64),he[Pe]=new Uint16Array(re*64);for(let Pe=0;Pe<Q;++Pe){let Ne=8;Pe==Q-1&&(Ne=ue);let gt=8;for(let qe=0;qe<re;++qe){qe==re-1&&(gt=ee);for(let Oe=0;Oe<G;++Oe)We[Oe].fill(0),We[Oe][0]=P[pe[Oe]++],qt(de,C,We[Oe]),vn(We[Oe],Te[Oe]),_n(Te[Oe]);G==3&&An(Te);for(let Oe=0;Oe<G;++Oe)Ct(Te[Oe],he[Oe],qe*64)}let nt=0;for(let qe=0;qe<G;++qe){let Oe=M[_.idx[qe]].type;for(let lt=8*Pe;lt<8*Pe+Ne;++lt){nt=Ye[qe][lt];for(let Ft=0;Ft<Y;++Ft){let Ze=Ft*64+(lt&7)*8;N.setUint16(nt+0*Oe,he[qe][Ze+0],!0),N.setUint16(nt+2*Oe,he[qe][Ze+1],!0),N.setUint16(nt+4*Oe,he[qe][Ze+2],!0),N.setUint16(nt+6*Oe,he[qe][Ze+3],!0),N.setUint16(nt+8*Oe,he[qe][Ze+4],!0),N.setUint16(nt+10*Oe,he[qe][Ze+5],!0),N.setUint16(nt+12*Oe,he[qe][Ze+6],!0),N.setUint16(nt+14*Oe,he[qe][Ze+7],!0),nt+=16*Oe}}if(Y!=re)for(let lt=8*Pe;lt<8*Pe+Ne;++lt){let Ft=Ye[qe][lt]+8*Y*2*Oe,Ze=Y*64+(lt&7)*8;for(let St=0;St<gt;++St)N.setUint16(Ft+St*2*Oe,he[qe][Ze+St],!0)}}}let ye=new Uint16Array(X);N=new DataView(U.buffer);for(let Pe=0;Pe<G;++Pe){M[_.idx[Pe]].decoded=!0;let Ne=M[_.idx[Pe]].type;if(M[Pe].type==2)for(let gt=0;gt<H;++gt){let nt=Ye[Pe][gt];for(let qe=0;qe<X;++qe)ye[qe]=N.getUint16(nt+qe*2*Ne,!0);for(let qe=0;qe<X;++qe)N.setFloat32(nt+qe*2*Ne,xe.fromHalfFloat(ye[qe]),!0)}}}function Wn(_,d,M,C,P,U){let N=new DataView(U.buffer),X=M[_],H=X.width,G=X.height,Y=Math.ceil(H/8),re=Math.ceil(G/8),Q=Math.floor(H/8),ee=H-(Y-1)*8,ue=G-(re-1)*8,de={value:0},pe=0,Te=new Float32Array(64),We=new Uint16Array(64),he=new Uint16Array(Y*64);for(let Ye=0;Ye<re;++Ye){let ye=8;Ye==re-1&&(ye=ue);for(let Pe=0;Pe<Y;++Pe)We.fill(0),We[0]=P[pe++],qt(de,C,We),vn(We,Te),_n(Te),Ct(Te,he,Pe*64);for(let Pe=8*Ye;Pe<8*Ye+ye;++Pe){let Ne=d[_][Pe];for(let gt=0;gt<Q;++gt){let nt=gt*64+(Pe&7)*8;for(let qe=0;qe<8;++qe)N.setUint16(Ne+qe*2*X.type,he[nt+qe],!0);Ne+=16*X.type}if(Y!=Q){let gt=Q*64+(Pe&7)*8;for(let nt=0;nt<ee;++nt)N.setUint16(Ne+nt*2*X.type,he[gt+nt],!0)}}}X.decoded=!0}function qt(_,d,M){let C,P=1;for(;P<64;)C=d[_.value],C==65280?P=64:C>>8==255?P+=C&255:(M[P]=C,P++),_.value++}function vn(_,d){d[0]=xe.fromHalfFloat(_[0]),d[1]=xe.fromHalfFloat(_[1]),d[2]=xe.fromHalfFloat(_[5]),d[3]=xe.fromHalfFloat(_[6]),d[4]=xe.fromHalfFloat(_[14]),d[5]=xe.fromHalfFloat(_[15]),d[6]=xe.fromHalfFloat(_[27]),d[7]=xe.fromHalfFloat(_[28]),d[8]=xe.fromHalfFloat(_[2]),d[9]=xe.fromHalfFloat(_[4]),d[10]=xe.fromHalfFloat(_[7]),d[11]=xe.fromHalfFloat(_[13]),d[12]=xe.fromHalfFloat(_[16]),d[13]=xe.fromHalfFloat(_[26]),d[14]=xe.fromHalfFloat(_[29]),d[15]=xe.fromHalfFloat(_[42]),d[16]=xe.fromHalfFloat(_[3]),d[17]=xe.fromHalfFloat(_[8]),d[18]=xe.fromHalfFloat(_[12]),d[19]=xe.fromHalfFloat(_[17]),d[20]=xe.fromHalfFloat(_[25]),d[21]=xe.fromHalfFloat(_[30]),d[22]=xe.fromHalfFloat(_[41]),d[23]=xe.fromHalfFloat(_[43]),d[24]=xe.fromHalfFloat(_[9]),d[25]=xe.fromHalfFloat(_[11]),d[26]=xe.fromHalfFloat(_[18]),d[27]=xe.fromHalfFloat(_[24]),d[28]=xe.fromHalfFloat(_[31]),d[29]=xe.fromHalfFloat(_[40]),d[30]=xe.fromHalfFloat(_[44]),d[31]=xe.fromHalfFloat(_[53]),d[32]=xe.fromHalfFloat(_[10]),d[33]=xe.fromHalfFloat(_[19]),d[34]=xe.fromHalfFloat(_[23]),d[35]=xe.fromHalfFloat(_[32]),d[36]=xe.fromHalfFloat(_[39]),d[37]=xe.fromHalfFloat(_[45]),d[38]=xe.fromHalfFloat(_[52]),d[39]=xe.fromHalfFloat(_[54]),d[40]=xe.fromHalfFloat(_[20]),d[41]=xe.fromHalfFloat(_[22]),d[42]=xe.fromHalfFloat(_[33]),d[43]=xe.fromHalfFloat(_[38]),d[44]=xe.fromHalfFloat(_[46]),d[45]=xe.fromHalfFloat(_[51]),d[46]=xe.fromHalfFloat(_[55]),d[47]=xe.fromHalfFloat(_[60]),d[48]=xe.fromHalfFloat(_[21]),d[49]=xe.fromHalfFloat(_[34]),d[50]=xe.fromHalfFloat(_[37]),d[51]=xe.fromHalfFloat(_[47]),d[52]=xe.fromHalfFloat(_[50]),d[53]=xe.fromHalfFloat(_[56]),d[54]=xe.fromHalfFloat(_[59]),d[55]=xe.fromHalfFloat(_[61]),d[56]=xe.fromHalfFloat(_[35]),d[57]=xe.fromHalfFloat(_[36]),d[58]=xe.fromHalfFloat(_[48]),d[59]=xe.fromHalfFloat(_[49]),d[60]=xe.fromHalfFloat(_[57]),d[61]=xe.fromHalfFloat(_[58]),d[62]=xe.fromHalfFloat(_[62]),d[63]=xe.fromHalfFloat(_[63])}function _n(_){let d=.5*Math.cos(.7853975),M=.5*Math.cos(3.14159/16),C=.5*Math.cos(3.14159/8),P=.5*Math.cos(3*3.14159/16),U=.5*Math.cos(5*3.14159/16),N=.5*Math.cos(3*3.14159/8),X=.5*Math.cos(7*3.14159/16),H=new Array(4),G=new Array(4),Y=new Array(4),re=new Array(4);for(let Q=0;Q<8;++Q){let ee=Q*8;H[0]=C*_[ee+2],H[1]=N*_[ee+2],H[2]=C*_[ee+6],H[3]=N*_[ee+6],G[0]=M*_[ee+1]+P*_[ee+3]+U*_[ee+5]+X*_[ee+7],G[1]=P*_[ee+1]-X*_[ee+3]-M*_[ee+5]-U*_[ee+7],G[2]=U*_[ee+1]-M*_[ee+3]+X*_[ee+5]+P*_[ee+7],G[3]=X*_[ee+1]-U*_[ee+3]+P*_[ee+5]-M*_[ee+7],Y[0]=d*(_[ee+0]+_[ee+4]),Y[3]=d*(_[ee+0]-_[ee+4]),Y[1]=H[0]+H[3],Y[2]=H[1]-H[2],re[0]=Y[0]+Y[1],re[1]=Y[3]+Y[2],re[2]=Y[3]-Y[2],re[3]=Y[0]-Y[1],_[ee+0]=re[0]+G[0],_[ee+1]=re[1]+G[1],_[ee+2]=re[2]+G[2],_[ee+3]=re[3]+G[3],_[ee+4]=re[3]-G[3],_[ee+5]=re[2]-G[2],_[ee+6]=re[1]-G[1],_[ee+7]=re[0]-G[0]}for(let Q=0;Q<8;++Q)H[0]=C*_[16+Q],H[1]=N*_[16+Q],H[2]=C*_[48+Q],H[3]=N*_[48+Q],G[0]=M*_[8+Q]+P*_[24+Q]+U*_[40+Q]+X*_[56+Q],G[1]=P*_[8+Q]-X*_[24+Q]-M*_[40+Q]-U*_[56+Q],G[2]=U*_[8+Q]-M*_[24+Q]+X*_[40+Q]+P*_[56+Q],G[3]=X*_[8+Q]-U*_[24+Q]+P*_[40+Q]-M*_[56+Q],Y[0]=d*(_[Q]+_[32+Q]),Y[3]=d*(_[Q]-_[32+Q]),Y[1]=H[0]+H[3],Y[2]=H[1]-H[2],re[0]=Y[0]+Y[1],re[1]=Y[3]+Y[2],re[2]=Y[3]-Y[2],re[3]=Y[0]-Y[1],_[0+Q]=re[0]+G[0],_[8+Q]=re[1]+G[1],_[16+Q]=re[2]+G[2],_[24+Q]=re[3]+G[3],_[32+Q]=re[3]-G[3],_[40+Q]=re[2]-G[2],_[48+Q]=re[1]-G[1],_[56+Q]=re[0]-G[0]}function An(_){for(let d=0;d<64;++d){let M=_[0][d],C=_[1][d],P=_[2][d];_[0][d]=M+1.5747*P,_[1][d]=M-.1873*C-.4682*P,_[2][d]=M+1.8556*C}}let V=new Float32Array(1),yn=new Uint32Array(V.buffer);function Rt(_){V[0]=_;let d=yn[0],M=d>>>16&32768,C=d&2147483647;if(C>=1199570944)return M|(C>2139095040?32256:31744);if(C<947912704)return V[0]=Math.abs(_)+.5,M|yn[0]-1056964608;let P=C+4095+(C>>>13&1);return M|P-939524096>>>13}function Ct(_,d,M){if(F===null){F=new Uint16Array(65536);for(let C=1;C<65536;++C){if((C&31744)===31744)continue;let P=xe.fromHalfFloat(C),U=Math.abs(P),N=U<=1?Math.pow(U,2.2):Math.pow(L,U-1);F[C]=Rt(P<0?-N:N)}}for(let C=0;C<64;++C)d[M+C]=F[Rt(_[C])]}function Ce(_){return new DataView(_.array.buffer,_.offset.value,_.size)}function Yt(_){let d=_.viewer.buffer.slice(_.offset.value,_.offset.value+_.size),M=new Uint8Array(sn(d)),C=new Uint8Array(M.length);return Vt(M),Bt(M,C),new DataView(C.buffer)}function Ge(_){let d=_.array.slice(_.offset.value,_.offset.value+_.size),M=Hr(d),C=new Uint8Array(M.length);return Vt(M),Bt(M,C),new DataView(C.buffer)}function je(_){let d=_.viewer,M={value:_.offset.value},C=new Uint16Array(_.columns*_.lines*(_.inputChannels.length*_.type)),P=new Uint8Array(8192),U=0,N=new Array(_.inputChannels.length);for(let ue=0,de=_.inputChannels.length;ue<de;ue++)N[ue]={},N[ue].start=U,N[ue].end=N[ue].start,N[ue].nx=_.columns,N[ue].ny=_.lines,N[ue].size=_.type,U+=N[ue].nx*N[ue].ny*N[ue].size;let X=ve(d,M),H=ve(d,M);if(H>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(X<=H)for(let ue=0;ue<H-X+1;ue++)P[ue+X]=k(d,M);let G=new Uint16Array(65536),Y=B(P,G),re=se(d,M);mt(_.array,d,M,re,C,U);for(let ue=0;ue<_.inputChannels.length;++ue){let de=N[ue];for(let pe=0;pe<N[ue].size;++pe)Ve(C,de.start+pe,de.nx,de.size,de.ny,de.nx*de.size,Y)}at(G,C,U);let Q=0,ee=new Uint8Array(C.buffer.byteLength);for(let ue=0;ue<_.lines;ue++)for(let de=0;de<_.inputChannels.length;de++){let pe=N[de],Te=pe.nx*pe.size,We=new Uint8Array(C.buffer,pe.end*2,Te*2);ee.set(We,Q),Q+=Te*2,pe.end+=Te}return new DataView(ee.buffer)}function O(_){let d=_.array.slice(_.offset.value,_.offset.value+_.size),M=Hr(d),C=_.inputChannels.length*_.lines*_.columns*_.totalBytes,P=new ArrayBuffer(C),U=new DataView(P),N=0,X=0,H=new Array(4);for(let G=0;G<_.lines;G++)for(let Y=0;Y<_.inputChannels.length;Y++){let re=0;switch(_.inputChannels[Y].pixelType){case 1:H[0]=N,H[1]=H[0]+_.columns,N=H[1]+_.columns;for(let ee=0;ee<_.columns;++ee){let ue=M[H[0]++]<<8|M[H[1]++];re+=ue,U.setUint16(X,re,!0),X+=2}break;case 2:H[0]=N,H[1]=H[0]+_.columns,H[2]=H[1]+_.columns,N=H[2]+_.columns;for(let ee=0;ee<_.columns;++ee){let ue=M[H[0]++]<<24|M[H[1]++]<<16|M[H[2]++]<<8;re+=ue,U.setUint32(X,re,!0),X+=4}break}}return U}function R(_){let d=_.array,M=_.offset.value,C=_.columns,P=_.lines,U=_.inputChannels,N=_.totalBytes,X=rn.compression==="B44A_COMPRESSION",H=new Uint8Array(P*C*N),G=new Uint16Array(16),Y=0;for(let re=0;re<U.length;re++){let Q=U[re],ee=Q.pixelType*2,ue=Math.ceil(C/Q.xSampling),de=Math.ceil(P/Q.ySampling),pe=Q.xSampling===1&&Q.ySampling===1;if(Q.pixelType!==1){for(let he=0;he<de;he++)if(pe){let Ye=he*C*N+Y*C;for(let ye=0;ye<ue*ee;ye++)H[Ye+ye]=d[M++]}else M+=ue*ee;Y+=ee;continue}let Te=Math.ceil(ue/4),We=Math.ceil(de/4);for(let he=0;he<We;he++)for(let Ye=0;Ye<Te;Ye++){if(X&&d[M+2]>=52){let ye=d[M]<<8|d[M+1],Pe=ye&32768?ye&32767:~ye&65535;G.fill(Pe),M+=3}else{let ye=d[M]<<8|d[M+1],Pe=d[M+2]>>2,Ne=32<<Pe,gt=ye+((d[M+2]<<4|d[M+3]>>4)&63)*(1<<Pe)-Ne&65535,nt=gt+((d[M+3]<<2|d[M+4]>>6)&63)*(1<<Pe)-Ne&65535,qe=nt+(d[M+4]&63)*(1<<Pe)-Ne&65535,Oe=ye+(d[M+5]>>2&63)*(1<<Pe)-Ne&65535,lt=gt+((d[M+5]<<4|d[M+6]>>4)&63)*(1<<Pe)-Ne&65535,Ft=nt+((d[M+6]<<2|d[M+7]>>6)&63)*(1<<Pe)-Ne&65535,Ze=qe+(d[M+7]&63)*(1<<Pe)-Ne&65535,St=Oe+(d[M+8]>>2&63)*(1<<Pe)-Ne&65535,un=lt+((d[M+8]<<4|d[M+9]>>4)&63)*(1<<Pe)-Ne&65535,os=Ft+((d[M+9]<<2|d[M+10]>>6)&63)*(1<<Pe)-Ne&65535,ui=Ze+(d[M+10]&63)*(1<<Pe)-Ne&65535,ws=St+(d[M+11]>>2&63)*(1<<Pe)-Ne&65535,pa=un+((d[M+11]<<4|d[M+12]>>4)&63)*(1<<Pe)-Ne&65535,ma=os+((d[M+12]<<2|d[M+13]>>6)&63)*(1<<Pe)-Ne&65535,ga=ui+(d[M+13]&63)*(1<<Pe)-Ne&65535,Zr=[ye,Oe,St,ws,gt,lt,un,pa,nt,Ft,os,ma,qe,Ze,ui,ga];for(let Js=0;Js<16;Js++)G[Js]=Zr[Js]&32768?Zr[Js]&32767:~Zr[Js]&65535;M+=14}if(Q.pLinear){if(I===null){I=new Uint16Array(65536);for(let ye=0;ye<65536;ye++)if((ye&31744)===31744||ye>32768)I[ye]=0;else{let Pe=xe.fromHalfFloat(ye);I[ye]=Pe<=0?0:xe.toHalfFloat(8*Math.log(Pe))}}for(let ye=0;ye<16;ye++)G[ye]=I[G[ye]]}for(let ye=0;ye<4;ye++){let Pe=he*4+ye;if(!(Pe>=de))for(let Ne=0;Ne<4;Ne++){let gt=Ye*4+Ne;if(gt>=ue)continue;let nt=G[ye*4+Ne];for(let qe=0;qe<Q.ySampling;qe++){let Oe=Pe*Q.ySampling+qe;if(!(Oe>=P))for(let lt=0;lt<Q.xSampling;lt++){let Ft=gt*Q.xSampling+lt;if(Ft>=C)continue;let Ze=Oe*C*N+Y*C+Ft*2;H[Ze]=nt&255,H[Ze+1]=nt>>8&255}}}}}Y+=2}return new DataView(H.buffer)}function Z(_){let d=_.viewer,M={value:_.offset.value},C=new Uint8Array(_.columns*_.lines*(_.inputChannels.length*_.type*2)),P={version:ne(d,M),unknownUncompressedSize:ne(d,M),unknownCompressedSize:ne(d,M),acCompressedSize:ne(d,M),dcCompressedSize:ne(d,M),rleCompressedSize:ne(d,M),rleUncompressedSize:ne(d,M),rleRawSize:ne(d,M),totalAcUncompressedCount:ne(d,M),totalDcUncompressedCount:ne(d,M),acCompression:ne(d,M)};if(P.version<2)throw new Error("THREE.EXRLoader: "+rn.compression+" version "+P.version+" is unsupported");let U=new Array,N=ve(d,M)-2;for(;N>0;){let de=ge(d.buffer,M),pe=k(d,M),Te=pe>>2&3,We=(pe>>4)-1,he=new Int8Array([We])[0],Ye=k(d,M);U.push({name:de,index:he,type:Ye,compression:Te}),N-=de.length+3}let X=rn.channels,H=new Array(_.inputChannels.length);for(let de=0;de<_.inputChannels.length;++de){let pe=H[de]={},Te=X[de];pe.name=Te.name,pe.compression=0,pe.decoded=!1,pe.type=Te.pixelType,pe.pLinear=Te.pLinear,pe.width=_.columns,pe.height=_.lines}let G={idx:new Array(3)};for(let de=0;de<_.inputChannels.length;++de){let pe=H[de],Te=pe.name.lastIndexOf("."),We=Te>=0?pe.name.substring(Te+1):pe.name;for(let he=0;he<U.length;++he){let Ye=U[he];We===Ye.name&&pe.type===Ye.type&&(pe.compression=Ye.compression,Ye.index>=0&&(G.idx[Ye.index]=de),pe.offset=de)}}let Y,re,Q;if(P.acCompressedSize>0)switch(P.acCompression){case 0:Y=new Uint16Array(P.totalAcUncompressedCount),mt(_.array,d,M,P.acCompressedSize,Y,P.totalAcUncompressedCount);break;case 1:let de=_.array.slice(M.value,M.value+P.totalAcUncompressedCount),pe=Hr(de);Y=new Uint16Array(pe.buffer),M.value+=P.totalAcUncompressedCount;break}if(P.dcCompressedSize>0){let de={array:_.array,offset:M,size:P.dcCompressedSize};re=new Uint16Array(Ge(de).buffer),M.value+=P.dcCompressedSize}if(P.rleRawSize>0){let de=_.array.slice(M.value,M.value+P.rleCompressedSize),pe=Hr(de);Q=sn(pe.buffer),M.value+=P.rleCompressedSize}let ee=0,ue=new Array(H.length);for(let de=0;de<ue.length;++de)ue[de]=new Array;for(let de=0;de<_.lines;++de)for(let pe=0;pe<H.length;++pe)ue[pe].push(ee),ee+=H[pe].width*_.type*2;G.idx[0]!==void 0&&H[G.idx[0]]&&Dt(G,ue,H,Y,re,C);for(let de=0;de<H.length;++de){let pe=H[de];if(!pe.decoded)switch(pe.compression){case 2:let Te=0,We=0;for(let he=0;he<_.lines;++he){let Ye=ue[de][Te];for(let ye=0;ye<pe.width;++ye){for(let Pe=0;Pe<2*pe.type;++Pe)C[Ye++]=Q[We+Pe*pe.width*pe.height];We++}Te++}break;case 1:Wn(de,ue,H,Y,re,C);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(C.buffer)}function ge(_,d){let M=new Uint8Array(_),C=0;for(;M[d.value+C]!=0;)C+=1;let P=new TextDecoder().decode(M.slice(d.value,d.value+C));return d.value=d.value+C+1,P}function le(_,d,M){let C=new TextDecoder().decode(new Uint8Array(_).slice(d.value,d.value+M));return d.value=d.value+M,C}function be(_,d){let M=te(_,d),C=se(_,d);return[M,C]}function Ie(_,d){let M=se(_,d),C=se(_,d);return[M,C]}function te(_,d){let M=_.getInt32(d.value,!0);return d.value=d.value+4,M}function se(_,d){let M=_.getUint32(d.value,!0);return d.value=d.value+4,M}function Me(_,d){let M=_[d.value];return d.value=d.value+1,M}function k(_,d){let M=_.getUint8(d.value);return d.value=d.value+1,M}let ne=function(_,d){let M=Number(_.getBigInt64(d.value,!0));return d.value+=8,M};function j(_,d){let M=_.getFloat32(d.value,!0);return d.value+=4,M}function Ae(_,d){return xe.toHalfFloat(j(_,d))}function ve(_,d){let M=_.getUint16(d.value,!0);return d.value+=2,M}function Se(_,d){return xe.fromHalfFloat(ve(_,d))}function Be(_,d,M,C){let P=M.value,U=[];for(;M.value<P+C-1;){let N=ge(d,M),X=te(_,M),H=k(_,M);M.value+=3;let G=te(_,M),Y=te(_,M);U.push({name:N,pixelType:X,pLinear:H,xSampling:G,ySampling:Y})}return M.value+=1,U}function tt(_,d){let M=j(_,d),C=j(_,d),P=j(_,d),U=j(_,d),N=j(_,d),X=j(_,d),H=j(_,d),G=j(_,d);return{redX:M,redY:C,greenX:P,greenY:U,blueX:N,blueY:X,whiteX:H,whiteY:G}}function _e(_,d){let M=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],C=k(_,d);return M[C]}function He(_,d){let M=te(_,d),C=te(_,d),P=te(_,d),U=te(_,d);return{xMin:M,yMin:C,xMax:P,yMax:U}}function Qe(_,d){let M=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],C=k(_,d);return M[C]}function Le(_,d){let M=["ENVMAP_LATLONG","ENVMAP_CUBE"],C=k(_,d);return M[C]}function vt(_,d){let M=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],C=["ROUND_DOWN","ROUND_UP"],P=se(_,d),U=se(_,d),N=k(_,d);return{xSize:P,ySize:U,levelMode:M[N&15],roundingMode:C[N>>4]}}function jt(_,d){let M=j(_,d),C=j(_,d);return[M,C]}function ci(_,d){let M=j(_,d),C=j(_,d),P=j(_,d);return[M,C,P]}function aa(_,d,M,C,P){if(C==="string"||C==="stringvector"||C==="iccProfile")return le(d,M,P);if(C==="chlist")return Be(_,d,M,P);if(C==="chromaticities")return tt(_,M);if(C==="compression")return _e(_,M);if(C==="box2i")return He(_,M);if(C==="envmap")return Le(_,M);if(C==="tiledesc")return vt(_,M);if(C==="lineOrder")return Qe(_,M);if(C==="float")return j(_,M);if(C==="v2f")return jt(_,M);if(C==="v3f")return ci(_,M);if(C==="int")return te(_,M);if(C==="rational")return be(_,M);if(C==="timecode")return Ie(_,M);if(C==="preview"||C==="deepImageState"||C==="idmanifest")return M.value+=P,"skipped";M.value+=P}function $r(_,d){let M=Math.log2(_);return d=="ROUND_DOWN"?Math.floor(M):Math.ceil(M)}function jc(_,d,M){let C=0;switch(_.levelMode){case"ONE_LEVEL":C=1;break;case"MIPMAP_LEVELS":C=$r(Math.max(d,M),_.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return C}function Xr(_,d,M,C){let P=new Array(_);for(let U=0;U<_;U++){let N=1<<U,X=d/N|0;C=="ROUND_UP"&&X*N<d&&(X+=1);let H=Math.max(X,1);P[U]=(H+M-1)/M|0}return P}function la(){let _=this,d=_.offset,M={value:0};for(let C=0;C<_.tileCount;C++){let P=te(_.viewer,d),U=te(_.viewer,d);d.value+=8,_.size=se(_.viewer,d);let N=P*_.blockWidth,X=U*_.blockHeight;_.columns=N+_.blockWidth>_.width?_.width-N:_.blockWidth,_.lines=X+_.blockHeight>_.height?_.height-X:_.blockHeight;let H=_.columns*_.totalBytes,Y=_.size<_.lines*H?_.uncompress(_):Ce(_);d.value+=_.size;for(let re=0;re<_.lines;re++){let Q=re*_.columns*_.totalBytes;for(let ee=0;ee<_.inputChannels.length;ee++){let ue=rn.channels[ee].name,de=_.channelByteOffsets[ue]*_.columns,pe=_.decodeChannels[ue];if(pe===void 0)continue;M.value=Q+de;let Te=(_.height-(1+X+re))*_.outLineWidth;for(let We=0;We<_.columns;We++){let he=Te+(We+N)*_.outputChannels+pe;_.byteArray[he]=_.getter(Y,M)}}}}}function Ci(){let _=this,d=_.offset,M={value:0};for(let C=0;C<_.height/_.blockHeight;C++){let P=te(_.viewer,d)-rn.dataWindow.yMin;_.size=se(_.viewer,d),_.lines=P+_.blockHeight>_.height?_.height-P:_.blockHeight;let U=_.columns*_.totalBytes,X=_.size<_.lines*U?_.uncompress(_):Ce(_);d.value+=_.size;for(let H=0;H<_.lines;H++){let G=P+H,Y=H*U,re=(_.height-1-G)*_.outLineWidth;for(let Q=0;Q<_.inputChannels.length;Q++){let ee=rn.channels[Q].name,ue=_.channelByteOffsets[ee]*_.columns,de=_.decodeChannels[ee];if(de!==void 0){M.value=Y+ue;for(let pe=0;pe<_.columns;pe++){let Te=re+pe*_.outputChannels+de;_.byteArray[Te]=_.getter(X,M)}}}}}}function qr(){let _=this,d=_.chunkOffsets,M={value:0};for(let C=0;C<d.length;C++){let P={value:d[C]};P.value+=4;let U=te(_.viewer,P)-rn.dataWindow.yMin;_.size=se(_.viewer,P),_.lines=U+_.blockHeight>_.height?_.height-U:_.blockHeight;let N=_.columns*_.totalBytes,X=_.size<_.lines*N,H=_.offset;_.offset=P;let G=X?_.uncompress(_):Ce(_);_.offset=H;for(let Y=0;Y<_.lines;Y++){let re=U+Y,Q=Y*N,ee=(_.height-1-re)*_.outLineWidth;for(let ue=0;ue<_.inputChannels.length;ue++){let de=rn.channels[ue].name,pe=_.channelByteOffsets[de]*_.columns,Te=_.decodeChannels[de];if(Te!==void 0){M.value=Q+pe;for(let We=0;We<_.columns;We++){let he=ee+We*_.outputChannels+Te;_.byteArray[he]=_.getter(G,M)}}}}}}function Yr(_,d,M,C){if(M===0)return null;let P=_.slice(d,d+M);switch(C){case"NO_COMPRESSION":return new DataView(P.buffer,P.byteOffset,P.byteLength);case"RLE_COMPRESSION":{let U=new Uint8Array(sn(P.buffer.slice(P.byteOffset,P.byteOffset+P.byteLength))),N=new Uint8Array(U.length);return Vt(U),Bt(U,N),new DataView(N.buffer)}case"ZIPS_COMPRESSION":{let U=Hr(P),N=new Uint8Array(U.length);return Vt(U),Bt(U,N),new DataView(N.buffer)}default:throw new Error("THREE.EXRLoader: "+C+" is unsupported for deep data")}}function ca(){let _=this,d=_.chunkOffsets,M=_.width,C=_.height,P=_.deepChannels,U=rn.compression,N=_.multiPart,X=_.decodeChannels,H=_.outputChannels,G=_.byteArray instanceof Uint16Array,Y=-1;for(let re=0;re<P.length;re++)if(P[re].name==="A"){Y=re;break}for(let re=0;re<d.length;re++){let Q={value:d[re]};N&&(Q.value+=4);let ee=te(_.viewer,Q)-rn.dataWindow.yMin,ue=ne(_.viewer,Q),de=ne(_.viewer,Q);ne(_.viewer,Q);let pe=Yr(_.array,Q.value,ue,U);if(Q.value+=ue,pe===null)continue;let Te=new Uint32Array(M);for(let Ne=0;Ne<M;Ne++)Te[Ne]=pe.getUint32(Ne*4,!0);let We=Te[M-1];if(We===0){Q.value+=de;continue}let he=Yr(_.array,Q.value,de,U),Ye=[],ye=0;for(let Ne=0;Ne<P.length;Ne++)Ye.push(ye),ye+=We*P[Ne].bytesPerSample;let Pe=(C-1-ee)*_.outLineWidth;for(let Ne=0;Ne<M;Ne++){let gt=Ne===0?0:Te[Ne-1],qe=Te[Ne]-gt;if(qe===0)continue;let Oe=new Float32Array(H),lt=0;for(let Ze=0;Ze<qe;Ze++){let St=gt+Ze,un=1-lt;if(un<=0)break;let os=1;if(Y>=0){let ui=P[Y].bytesPerSample,ws=Ye[Y]+St*ui;os=ui===2?xe.fromHalfFloat(he.getUint16(ws,!0)):he.getFloat32(ws,!0)}for(let ui=0;ui<P.length;ui++){let ws=P[ui],pa=X[ws.name];if(pa===void 0)continue;let ma=ws.bytesPerSample,ga=Ye[ui]+St*ma,Zr=ma===2?xe.fromHalfFloat(he.getUint16(ga,!0)):he.getFloat32(ga,!0);Oe[pa]+=Zr*un}lt+=os*un}X.A!==void 0&&(Oe[X.A]=lt);let Ft=Pe+Ne*H;for(let Ze=0;Ze<H;Ze++)_.byteArray[Ft+Ze]=G?xe.toHalfFloat(Oe[Ze]):Oe[Ze]}}}function Ms(_,d,M){let C={},P=!1;for(;;){let U=ge(d,M);if(U==="")break;P=!0;let N=ge(d,M),X=se(_,M),H=aa(_,d,M,N,X);H===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${N}'.`):C[U]=H}return P?C:null}function ha(_,d,M){if(_.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let C=_.getUint8(4),P=_.getUint8(5),U={singleTile:!!(P&2),longName:!!(P&4),deepFormat:!!(P&8),multiPart:!!(P&16)};M.value=8;let N=[];if(U.multiPart){for(;;){let X=Ms(_,d,M);if(X===null)break;X.version=C,X.spec=U,N.push(X)}if(N.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let X=Ms(_,d,M);X.version=C,X.spec=U,N.push(X)}return N}function ua(_,d,M,C,P,U){let N={size:0,viewer:d,array:M,offset:C,width:_.dataWindow.xMax-_.dataWindow.xMin+1,height:_.dataWindow.yMax-_.dataWindow.yMin+1,inputChannels:_.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Ot};switch(_.compression){case"NO_COMPRESSION":N.blockHeight=1,N.uncompress=Ce;break;case"RLE_COMPRESSION":N.blockHeight=1,N.uncompress=Yt;break;case"ZIPS_COMPRESSION":N.blockHeight=1,N.uncompress=Ge;break;case"ZIP_COMPRESSION":N.blockHeight=16,N.uncompress=Ge;break;case"PIZ_COMPRESSION":N.blockHeight=32,N.uncompress=je;break;case"PXR24_COMPRESSION":N.blockHeight=16,N.uncompress=O;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":N.blockHeight=32,N.uncompress=R;break;case"DWAA_COMPRESSION":N.blockHeight=32,N.uncompress=Z;break;case"DWAB_COMPRESSION":N.blockHeight=256,N.uncompress=Z;break;default:throw new Error("THREE.EXRLoader: "+_.compression+" is unsupported")}let X={};for(let Q of _.channels)switch(Q.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":X[Q.name]=!0,N.type=Q.pixelType}let H=!1,G=!1;if(X.Y&&X.RY&&X.BY)N.outputChannels=4,N.yCbCr=!0;else if(X.R&&X.G&&X.B)N.outputChannels=4;else if(X.Y)N.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(N.outputChannels){case 4:U==yt?(H=!X.A,N.format=yt,N.colorSpace=Ot,N.outputChannels=4,N.decodeChannels={R:0,G:1,B:2,A:3}):U==Dn?(N.format=Dn,N.colorSpace=Ot,N.outputChannels=2,N.decodeChannels={R:0,G:1}):U==ts?(N.format=ts,N.colorSpace=Ot,N.outputChannels=1,N.decodeChannels={R:0}):G=!0;break;case 1:U==yt?(H=!0,N.format=yt,N.colorSpace=Ot,N.outputChannels=4,N.shouldExpand=!0,N.decodeChannels={Y:0}):U==Dn?(N.format=Dn,N.colorSpace=Ot,N.outputChannels=2,N.shouldExpand=!0,N.decodeChannels={Y:0}):U==ts?(N.format=ts,N.colorSpace=Ot,N.outputChannels=1,N.decodeChannels={Y:0}):G=!0;break;default:G=!0}if(G)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(N.yCbCr&&(N.format=yt,N.outputChannels=4,N.decodeChannels={Y:0,RY:1,BY:2},H=!0),N.type==1)switch(P){case _t:N.getter=Se;break;case Jt:N.getter=ve;break}else if(N.type==2)switch(P){case _t:N.getter=j;break;case Jt:N.getter=Ae}else throw new Error("THREE.EXRLoader: unsupported pixelType "+N.type+" for "+_.compression+".");N.columns=N.width;let Y=N.width*N.height*N.outputChannels;switch(P){case _t:N.byteArray=new Float32Array(Y),H&&N.byteArray.fill(1,0,Y);break;case Jt:N.byteArray=new Uint16Array(Y),H&&N.byteArray.fill(15360,0,Y);break;default:console.error("THREE.EXRLoader: unsupported type: ",P);break}let re=0;for(let Q of _.channels)N.decodeChannels[Q.name]!==void 0&&(N.channelByteOffsets[Q.name]=re),re+=Q.pixelType*2;if(N.totalBytes=re,N.outLineWidth=N.width*N.outputChannels,_.spec.deepFormat){N.deepChannels=[];let Q=0;for(let ee of _.channels){let ue=ee.pixelType===0?4:ee.pixelType*2;N.deepChannels.push({name:ee.name,pixelType:ee.pixelType,bytesPerSample:ue}),Q+=ue}N.deepBytesPerSample=Q,N.chunkOffsets=_._chunkOffsets,N.multiPart=_.spec.multiPart,N.decode=ca.bind(N)}else if(_.spec.singleTile){N.blockHeight=_.tiles.ySize,N.blockWidth=_.tiles.xSize;let Q=jc(_.tiles,N.width,N.height),ee=Xr(Q,N.width,_.tiles.xSize,_.tiles.roundingMode),ue=Xr(Q,N.height,_.tiles.ySize,_.tiles.roundingMode);N.tileCount=ee[0]*ue[0];for(let de=0;de<Q;de++)for(let pe=0;pe<ue[de];pe++)for(let Te=0;Te<ee[de];Te++)ne(d,C);N.decode=la.bind(N)}else if(_.spec.multiPart)N.blockWidth=N.width,N.chunkOffsets=_._chunkOffsets,N.decode=qr.bind(N);else{N.blockWidth=N.width;let Q=Math.ceil(N.height/N.blockHeight);for(let ee=0;ee<Q;ee++)ne(d,C);N.decode=Ci.bind(N)}return N}let hi={value:0},Ks=new DataView(e),fa=new Uint8Array(e),Ss=ha(Ks,e,hi),da=Math.max(0,Math.min(this.part,Ss.length-1)),rn=Ss[da];if(rn.spec.multiPart||rn.spec.deepFormat)for(let _=0;_<Ss.length;_++){let d=Ss[_].chunkCount;if(_===da){rn._chunkOffsets=[];for(let M=0;M<d;M++)rn._chunkOffsets.push(ne(Ks,hi))}else for(let M=0;M<d;M++)ne(Ks,hi)}let Tn=ua(rn,Ks,fa,hi,this.type,this.outputFormat);if(Tn.decode(),Tn.shouldExpand){let _=Tn.byteArray;if(this.outputFormat==yt)for(let d=0;d<_.length;d+=4)_[d+2]=_[d+1]=_[d];else if(this.outputFormat==Dn)for(let d=0;d<_.length;d+=2)_[d+1]=_[d]}if(Tn.yCbCr){let _=Tn.byteArray,d=Tn.width*Tn.height;if(this.type===Jt)for(let M=0;M<d;M++){let C=M*4,P=xe.fromHalfFloat(_[C]),U=xe.fromHalfFloat(_[C+1]),N=xe.fromHalfFloat(_[C+2]),X=(1+U)*P,H=(1+N)*P,G=(P-X*.2126-H*.0722)/.7152;_[C]=xe.toHalfFloat(Math.max(0,X)),_[C+1]=xe.toHalfFloat(Math.max(0,G)),_[C+2]=xe.toHalfFloat(Math.max(0,H))}else for(let M=0;M<d;M++){let C=M*4,P=_[C],U=_[C+1],N=_[C+2],X=(1+U)*P,H=(1+N)*P;_[C]=Math.max(0,X),_[C+1]=Math.max(0,(P-X*.2126-H*.0722)/.7152),_[C+2]=Math.max(0,H)}}return{header:rn,width:Tn.width,height:Tn.height,data:Tn.byteArray,format:Tn.format,colorSpace:Tn.colorSpace,type:this.type,minFilter:Et,magFilter:Et,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var Dc=class extends zs{constructor(e){super(e),this.type=Jt}parse(e){let o=function(b,L){switch(b){case 1:throw new Error("THREE.HDRLoader: Read Error: "+(L||""));case 2:throw new Error("THREE.HDRLoader: Write Error: "+(L||""));case 3:throw new Error("THREE.HDRLoader: Bad File Format: "+(L||""));default:case 4:throw new Error("THREE.HDRLoader: Memory Error: "+(L||""))}},u=function(b,L,I){L=L||1024;let B=b.pos,z=-1,D=0,W="",q=String.fromCharCode.apply(null,new Uint16Array(b.subarray(B,B+128)));for(;0>(z=q.indexOf(`
`))&&D<L&&B<b.byteLength;)W+=q,D+=q.length,B+=128,q=String.fromCharCode.apply(null,new Uint16Array(b.subarray(B,B+128)));return-1<z?(I!==!1&&(b.pos+=D+z+1),W+q.slice(0,z)):!1},f=function(b){let L=/^#\?(\S+)/,I=/^\s*GAMMA\s*=\s*(\d+(\.\d+)?)\s*$/,F=/^\s*EXPOSURE\s*=\s*(\d+(\.\d+)?)\s*$/,B=/^\s*FORMAT=(\S+)\s*$/,z=/^\s*\-Y\s+(\d+)\s+\+X\s+(\d+)\s*$/,D={valid:0,string:"",comments:"",programtype:"RGBE",format:"",gamma:1,exposure:1,width:0,height:0},W,q;for((b.pos>=b.byteLength||!(W=u(b)))&&o(1,"no header found"),(q=W.match(L))||o(3,"bad initial token"),D.valid|=1,D.programtype=q[1],D.string+=W+`
`;W=u(b),W!==!1;){if(D.string+=W+`
`,W.charAt(0)==="#"){D.comments+=W+`
`;continue}if((q=W.match(I))&&(D.gamma=parseFloat(q[1])),(q=W.match(F))&&(D.exposure=parseFloat(q[1])),(q=W.match(B))&&(D.valid|=2,D.format=q[1]),(q=W.match(z))&&(D.valid|=4,D.height=parseInt(q[1],10),D.width=parseInt(q[2],10)),D.valid&2&&D.valid&4)break}return D.valid&2||o(3,"missing format specifier"),D.valid&4||o(3,"missing image size specifier"),D},p=function(b,L,I){let F=L;if(F<8||F>32767||b[0]!==2||b[1]!==2||b[2]&128)return new Uint8Array(b);F!==(b[2]<<8|b[3])&&o(3,"wrong scanline width");let B=new Uint8Array(4*L*I);B.length||o(4,"unable to allocate buffer space");let z=0,D=0,W=4*F,q=new Uint8Array(4),K=new Uint8Array(W),fe=I;for(;fe>0&&D<b.byteLength;){D+4>b.byteLength&&o(1),q[0]=b[D++],q[1]=b[D++],q[2]=b[D++],q[3]=b[D++],(q[0]!=2||q[1]!=2||(q[2]<<8|q[3])!=F)&&o(3,"bad rgbe scanline format");let J=0,ae;for(;J<W&&D<b.byteLength;){ae=b[D++];let we=ae>128;if(we&&(ae-=128),(ae===0||J+ae>W)&&o(3,"bad scanline data"),we){let De=b[D++];for(let ie=0;ie<ae;ie++)K[J++]=De}else K.set(b.subarray(D,D+ae),J),J+=ae,D+=ae}let ce=F;for(let we=0;we<ce;we++){let De=0;B[z]=K[we+De],De+=F,B[z+1]=K[we+De],De+=F,B[z+2]=K[we+De],De+=F,B[z+3]=K[we+De],z+=4}fe--}return B},g=function(b,L,I,F){let B=b[L+3],z=Math.pow(2,B-128)/255;I[F+0]=b[L+0]*z,I[F+1]=b[L+1]*z,I[F+2]=b[L+2]*z,I[F+3]=1},y=function(b,L,I,F){let B=b[L+3],z=Math.pow(2,B-128)/255;I[F+0]=xe.toHalfFloat(Math.min(b[L+0]*z,65504)),I[F+1]=xe.toHalfFloat(Math.min(b[L+1]*z,65504)),I[F+2]=xe.toHalfFloat(Math.min(b[L+2]*z,65504)),I[F+3]=xe.toHalfFloat(1)},m=new Uint8Array(e);m.pos=0;let v=f(m),A=v.width,S=v.height,w=p(m.subarray(m.pos),A,S),T,E,x;switch(this.type){case _t:x=w.length/4;let b=new Float32Array(x*4);for(let I=0;I<x;I++)g(w,I*4,b,I*4);T=b,E=_t;break;case Jt:x=w.length/4;let L=new Uint16Array(x*4);for(let I=0;I<x;I++)y(w,I*4,L,I*4);T=L,E=Jt;break;default:throw new Error("THREE.HDRLoader: Unsupported type: "+this.type)}return{width:A,height:S,data:T,header:v.string,gamma:v.gamma,exposure:v.exposure,type:E,colorSpace:Ot,minFilter:Et,magFilter:Et,generateMipmaps:!1,flipY:!0}}setDataType(e){return this.type=e,this}};var pt=128,Tt=64,ss=1024,MS=.5;function Gr(i){let e=new Float32Array(3*pt*Tt);for(let t=0;t<Tt;t+=1)for(let n=0;n<pt;n+=1)e.set(SS(i,vg((n+.5)/pt,(t+.5)/Tt)),3*(t*pt+n));return e}function vg(i,e){let[t,n]=[2*Math.PI*i,Math.PI*e];return[Math.sin(n)*Math.sin(t),Math.cos(n),Math.sin(n)*Math.cos(t)]}function SS(i,e){return i==="dome"?[1,1,1]:i==="sky"?wS(e):i==="studio"?RS(e):[0,0,0]}var Ys=(i,e,t)=>{let n=Math.min(Math.max((t-i)/(e-i),0),1);return n*n*(3-2*n)},Fc=(i,e,t)=>[i[0]+t*(e[0]-i[0]),i[1]+t*(e[1]-i[1]),i[2]+t*(e[2]-i[2])],ra=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],wf=i=>{let e=Math.hypot(...i);return[i[0]/e,i[1]/e,i[2]/e]};function wS(i){let e=Fc([1,.98,.94],[.28,.47,.86],Ys(0,.75,i[1])),t=Fc(Fc([.3,.27,.23],[.5,.47,.43],Ys(-.5,0,i[1])),e,Ys(-.05,.05,i[1])),n=wf([.75,.55,.5]),s=Math.exp(-((1-ra(i,n))/.03))*9+Math.exp(-((1-ra(i,n))/.25))*.5,r=Ys(-.05,.1,i[1]);return[t[0]+1*s*r,t[1]+.88*s*r,t[2]+.7*s*r]}function Af(i,e,t){let n=wf(i),s=wf([n[2],0,-n[0]]),r=[n[1]*s[2]-n[2]*s[1],n[2]*s[0]-n[0]*s[2],n[0]*s[1]-n[1]*s[0]];return o=>{let a=ra(o,n);if(a<=0)return 0;let l=Math.abs(ra(o,s))/a;return l>=1.1*e?0:(1-Ys(.8,1.1,l/e))*(1-Ys(.8,1.1,Math.abs(ra(o,r))/a/t))}}var AS=Af([-.8,.75,.6],.55,.4),TS=Af([1,.25,.15],.16,.7),ES=Af([.3,.8,-1],.7,.22);function RS(i){let e=Fc([.06,.055,.05],[.16,.165,.18],Ys(-.4,1,i[1])),t=4.2*AS(i),n=3*TS(i),s=4*ES(i);return[e[0]+1*t+.85*n+.95*s,e[1]+.96*t+.93*n+.97*s,e[2]+.88*t+1.05*n+1*s]}var Tf=(i,e)=>.2126*i[3*e]+.7152*i[3*e+1]+.0722*i[3*e+2];function _g(i){let e=0;for(let t=0;t<Tt/2;t+=1){let[n,s]=[Math.cos(Math.PI*t/Tt),Math.cos(Math.PI*(t+1)/Tt)],r=(n*n-s*s)/pt;for(let o=0;o<pt;o+=1)e+=r*Tf(i,t*pt+o)}return e}function CS(i){let e=0;for(let t=0;t<pt*Tt;t+=1)e+=Tf(i,t)*Math.sin(Math.PI*(Math.floor(t/pt)+.5)/Tt);return e*Math.PI/(2*Tt*pt)}function IS(i){let e=MS*CS(i),t=new Float32Array(8*ss),n=new Float64Array(pt*Tt),s=new Float64Array(Tt+1);for(let a=0;a<Tt;a+=1){let l=2*Math.PI/pt*(Math.cos(Math.PI*a/Tt)-Math.cos(Math.PI*(a+1)/Tt)),c=0;for(let h=0;h<pt;h+=1){let u=a*pt+h;n[u]=l*(Tf(i,u)+e),c+=n[u]}s[a+1]=s[a]+c}let r=s[Tt];if(!(r>0))return t;let o=1.324717957244746;for(let a=0;a<ss;a+=1){let l=(.5+(a+1)/o)%1,c=(.5+(a+1)/(o*o))%1,h=0;for(;h<Tt-1&&s[h+1]<l*r;)h+=1;let u=(l*r-s[h])/(s[h+1]-s[h]||1),f=0,p=0,g=c*(s[h+1]-s[h]);for(;f<pt-1&&p+n[h*pt+f]<g;)p+=n[h*pt+f],f+=1;let y=h*pt+f,m=(g-p)/(n[y]||1),[v,A]=[Math.cos(Math.PI*h/Tt),Math.cos(Math.PI*(h+1)/Tt)],S=Math.acos(v+u*(A-v)),T=2*Math.PI/pt*(v-A)*r/n[y];t.set(vg((f+m)/pt,S/Math.PI),8*a),t.set([i[3*y]*T,i[3*y+1]*T,i[3*y+2]*T],8*a+4)}return t}function yg(i){let e=new mn(IS(i),256,2*ss/256,yt,_t);return e.needsUpdate=!0,e}var bg=[".hdr",".exr"],Ef=2**25,xg=512*2**20,Mg=65536;function Sg(i,e){if(e.byteLength>xg)throw new oe(`${i} has ${Math.round(e.byteLength/2**20)} MiB, more than ${xg/2**20}`,"Make it smaller: the sky is shown in 64 x 128 cells");let t=i.toLowerCase().endsWith(".exr"),[n,s]=t?LS(i,e):PS(i,e);if(!(n>0&&s>0&&n*s<=Ef))throw new oe(`${i} claims ${n} x ${s} pixels, which is none or more than ${Ef.toLocaleString("en")}`,"Make it smaller: the sky is shown in 64 x 128 cells");if(Math.abs(n/s-2)>.05)throw new oe(`${i} has ${n} x ${s} pixels; a panorama is twice as wide as high`,"Open an equirectangular (latitude and longitude) picture");let r;try{r=(t?new Nc:new Dc).parse(e)}catch(o){throw new oe(`${i} is not a picture that can be read: ${o instanceof Error?o.message:String(o)}`,"Save it again as Radiance HDR or OpenEXR")}if(r.width!==n||r.height!==s)throw new oe(`${i} holds ${r.width} x ${r.height} pixels where its head says ${n} x ${s}`,"The file is damaged");return NS(i,r.data,n,s,t)}function PS(i,e){let t=new TextDecoder("latin1").decode(e.slice(0,Mg)),n=/\n-Y (\d+) \+X (\d+)\n/.exec(t);if(!t.startsWith("#?")||!n)throw new oe(`${i} has no head of a Radiance picture that is stored row by row from the top`,"Save it again as Radiance HDR or OpenEXR");let[s,r]=[Number(n[2]),Number(n[1])];if(e.byteLength-t.indexOf(n[0])-n[0].length<r*Math.min(4*s,4+8*Math.ceil(s/127))&&s*r<=Ef)throw new oe(`${i} breaks off within its pixels`,"The file is damaged; fetch it again");return[s,r]}function LS(i,e){let t=new TextDecoder("latin1").decode(e.slice(0,Mg)),n=t.indexOf("dataWindow\0box2i\0");if(!t.startsWith("v/1")||n<0||n+37>e.byteLength)throw new oe(`${i} has no head of an OpenEXR picture`,"Save it again as Radiance HDR or OpenEXR");let[s,r,o,a]=[0,1,2,3].map(l=>new DataView(e).getInt32(n+21+4*l,!0));return[o-s+1,a-r+1]}function NS(i,e,t,n,s){let r=e.length/(t*n),o=(h,u,f)=>{let p=e[((s?n-1-u:u)*t+h)*r+(r<3?0:f)],g=e instanceof Uint16Array?xe.fromHalfFloat(p):p;return Number.isFinite(g)&&g>0?g:0},a=new Float64Array(3*pt*Tt),l=new Float64Array(pt*Tt);for(let h=0;h<n;h+=1){let u=Math.sin(Math.PI*(h+.5)/n),f=Math.min(Math.floor((h+.5)*Tt/n),Tt-1);for(let p=0;p<t;p+=1){let g=f*pt+DS((p+.5)/t);l[g]+=u;for(let y=0;y<3;y+=1)a[3*g+y]+=u*o(p,h,y)}}let c=new Float32Array(3*pt*Tt);for(let h=0;h<pt*Tt;h+=1){let u=l[h],f=Math.min(Math.floor((1-(h%pt+.5)/pt)%1*t),t-1),p=Math.min(Math.floor((Math.floor(h/pt)+.5)*n/Tt),n-1);for(let g=0;g<3;g+=1)c[3*h+g]=u>0?a[3*h+g]/u:o(f,p,g)}if(!c.some(h=>h>0))throw new oe(`${i} is black`,"Open a picture with light in it");return c}function DS(i){return Math.min(Math.floor((1-i)*pt),pt-1)}var wg=256*2**20;async function Ag(i,e,t=!1){let n=i.name.toLowerCase(),s=n.slice(n.lastIndexOf("."));if(lg.includes(s)){await e.openMesh(i.name,await i.arrayBuffer());return}if(bg.includes(s)){e.openSky(i.name,Sg(i.name,await i.arrayBuffer()));return}if(![".json",".csv",".txt",".tsv",".dat"].includes(s))throw new oe(`${i.name} is neither a material, a table, a mesh nor a sky`,"Drop a .json, .csv, .obj, .ply, .glb, .hdr or .exr file");if(i.size>wg)throw new oe(`${i.name} has ${Math.round(i.size/2**20)} MiB, more than ${wg/2**20}`,"motes view DATA thins any measurement");let r=fd(await i.arrayBuffer());s===".json"?e.openMaterial(FS(i.name,r),t):e.openData(Cd(i.name,r))}function FS(i,e){try{return JSON.parse(e)}catch(t){throw new oe(`${i} is not JSON: ${t instanceof Error?t.message:String(t)}`,"Drop a material.json that motes fit wrote; NaN is not JSON")}}function Tg(i,e,t){i.addEventListener("dragover",n=>{n.preventDefault(),i.classList.add("motes-over")},{signal:t}),i.addEventListener("dragleave",()=>i.classList.remove("motes-over"),{signal:t}),i.addEventListener("drop",n=>{n.preventDefault(),i.classList.remove("motes-over");for(let s of Array.from(n.dataTransfer?.files??[]))Ag(s,e,n.shiftKey).catch(e.messages.fail)},{signal:t})}function Rf(i,e,t,n){let s=Ee("input",{type:"file",accept:e,class:"motes-offscreen",tabindex:-1,"aria-label":i});return s.addEventListener("change",()=>{let r=s.files?.[0];r&&Ag(r,t,n).catch(t.messages.fail),s.value=""}),Ee("span",{},$n(i,()=>s.click()),s)}var Uc=40,Ti=72,US=`
in vec3 tint;
out vec3 vTint;
out vec3 vPosition;
void main() {
  vTint = tint;
  vPosition = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`,OS=`
in vec3 vTint;
in vec3 vPosition;
out vec4 color;
void main() {
  vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
  float facing = abs(dot(normal, normalize(cameraPosition - vPosition)));
  color = vec4(vTint * (0.35 + 0.65 * facing), 1.0);
}`,Eg=(i,e,t)=>[-i,t,e],Oc=class{scene=new Yn;camera=new Kt(30,1,.1,50);wo;positions=new Float32Array(3*(Uc+1)*Ti);tints=new Float32Array(this.positions.length);geometry=new Lt;arrow=new zo(new $(0,-1,0),new $,1,14716960,.14,.08);lines=new Xi({color:8947848});visible=!0;reach=1;constructor(){let e=[];for(let s=0;s<=Uc;s+=1){let r=Math.min(s/Uc,.9999)*Math.PI/2;for(let o=0;o<Ti;o+=1){let a=2*Math.PI*o/Ti;e.push(Math.sin(r)*Math.cos(a),Math.sin(r)*Math.sin(a),Math.cos(r))}}this.wo=Float32Array.from(e);let t=[];for(let s=0;s<Uc;s+=1)for(let r=0;r<Ti;r+=1){let[o,a]=[s*Ti+r,s*Ti+(r+1)%Ti];t.push(o,o+Ti,a,a,o+Ti,a+Ti)}this.geometry.setIndex(t),this.geometry.setAttribute("position",new ut(this.positions,3)),this.geometry.setAttribute("tint",new ut(this.tints,3));let n=new At(this.geometry,new Ht({glslVersion:wn,vertexShader:US,fragmentShader:OS,side:Ln}));n.frustumCulled=!1,this.scene.add(n,this.ground(),this.arrow)}update(e,t,n,s){if(this.visible=e.lobe,!e.lobe)return;let r=Qt(e.incidence),o=[Math.sin(r),0,Math.cos(r)],a=this.wo.length/3,l=new Float32Array(3*a);for(let m=0;m<a;m+=1)l.set(o,3*m);let c=s.evaluate(t,n,l,this.wo),h=t.shader.channels,u=new Float32Array(3*a),f=new Float32Array(a);for(let m=0;m<a;m+=1){let v=0;for(let A=0;A<h;A+=1){let S=c[m*h+A];v+=S/h;for(let w=0;w<3;w+=1)u[3*m+w]+=S*t.toSrgb[A][w]}f[m]=hs(v*(e.radius==="f cos"?this.wo[3*m+2]:1),e.scale)}let p=0;for(let m of f)m>p&&(p=m);this.reach=p||1;let g=new Xe;for(let m=0;m<a;m+=1){let v=Fn(f[m]/this.reach,0,1);this.positions.set(Eg(this.wo[3*m]*v,this.wo[3*m+1]*v,this.wo[3*m+2]*v),3*m);let A=Math.max(u[3*m],u[3*m+1],u[3*m+2],1e-9);g.setRGB(Math.max(u[3*m],0)/A,Math.max(u[3*m+1],0)/A,Math.max(u[3*m+2],0)/A),this.tints.set([.25+.65*g.r**.45,.25+.65*g.g**.45,.25+.65*g.b**.45],3*m)}this.geometry.getAttribute("position").needsUpdate=!0,this.geometry.getAttribute("tint").needsUpdate=!0;let y=new $(...Eg(o[0],o[1],o[2]));this.arrow.position.copy(y.clone().multiplyScalar(1.12)),this.arrow.setDirection(y.clone().negate()),this.arrow.setLength(.9,.13,.08)}draw(e,t,n,s){if(!this.visible)return;let r=Math.round(Math.min(n,s)*.34),o=t.position.clone().normalize();o.y=Math.max(o.y,.16),this.camera.position.copy(o.normalize().multiplyScalar(4.6)).add(new $(0,.38,0)),this.camera.lookAt(0,.38,0),e.setRenderTarget(null),e.setViewport(0,0,r,r),e.clearDepth(),e.render(this.scene,this.camera),e.setViewport(0,0,n,s)}ground(){let e=new Bn;for(let t of[.5,1]){let n=Array.from({length:64},(s,r)=>new $(Math.cos(r*Math.PI/32)*t,0,Math.sin(r*Math.PI/32)*t));e.add(new Bs(new Lt().setFromPoints(n),this.lines))}return e.add(new yi(new Lt().setFromPoints([new $(-1,0,0),new $(1,0,0)]),this.lines)),e}};var Bc=class{constructor(e){this.shipped=e;for(let t of e.shapes)this.geometries.set(t.name,null)}shipped;geometries=new Map;own=new Map;get names(){return[...this.geometries.keys()]}get(e,t){let n=this.own.get(e);n&&n.up!==t&&(this.geometries.get(e)?.dispose(),this.geometries.set(e,yf(n.triangles,this.shipped.dust_by_inclination,t)),n.up=t);let s=this.geometries.get(e);if(s)return s;let r=this.shipped.shapes.find(a=>a.name===e)??this.shipped.shapes[0],o=this.geometries.get(r.name)??Jm(r);return this.geometries.set(r.name,o),o}isOwn(e){return this.own.has(e)}async add(e,t,n){let s=await cg(e,t),r=yf(s,this.shipped.dust_by_inclination,n);return this.geometries.get(e)?.dispose(),this.geometries.set(e,r),this.own.set(e,{triangles:s,up:n}),{triangles:r.getIndex().count/3,tau:xf(s)}}dispose(){for(let e of this.geometries.values())e?.dispose()}};var BS=4,kc=class{element;polite=Ee("div",{role:"status","aria-live":"polite"});urgent=Ee("div",{role:"alert"});constructor(){this.element=Ee("div",{class:"motes-messages"},this.urgent,this.polite)}say(e){this.put(this.polite,"said",e,"")}fail=e=>{let[t,n]=e instanceof oe?[e.message,e.hint]:[`The viewer failed in a way it should not: ${e instanceof Error?e.message:String(e)}`,"Load the page again and report this"];this.put(this.urgent,"failed",t,n)};put(e,t,n,s){let r=Ee("div",{class:`motes-message ${t}`},Ee("p",{},`${n.replace(/\.$/,"")}.`,s?Ee("span",{},` ${s.replace(/\.$/,"")}.`):null),Ee("button",{type:"button","aria-label":"Dismiss",onclick:()=>r.remove()},"×"));for(let o of Array.from(e.children))o.querySelector("p")?.textContent===r.querySelector("p").textContent&&o.remove();for(e.prepend(r);e.children.length>BS;)e.lastElementChild.remove()}};var Rg=.4;function Pg(i,e){let t=new Map,n=!1,s=0;i.addEventListener("contextmenu",a=>a.preventDefault()),i.addEventListener("pointerdown",a=>{i.setPointerCapture(a.pointerId),t.set(a.pointerId,{x:a.clientX,y:a.clientY}),n=a.shiftKey||a.button===2,s=Ig(t)}),i.addEventListener("pointermove",a=>{let l=t.get(a.pointerId);if(!l)return;let[c,h]=[a.clientX-l.x,a.clientY-l.y];if(t.set(a.pointerId,{x:a.clientX,y:a.clientY}),t.size>1){let u=Ig(t);s>0&&u>0&&o(s/u),s=u}else r(c*Rg,h*Rg,n)});for(let a of["pointerup","pointercancel"])i.addEventListener(a,l=>t.delete(l.pointerId));i.addEventListener("wheel",a=>{a.preventDefault(),o(Math.exp(Fn(a.deltaY,-200,200)*.0015))},{passive:!1}),i.addEventListener("keydown",a=>{let c={ArrowLeft:[-6,0],ArrowRight:[6,0],ArrowUp:[0,-6],ArrowDown:[0,6]}[a.key];if(c)r(c[0],c[1],a.shiftKey);else if(a.key==="+"||a.key==="=")o(.9);else if(a.key==="-")o(1/.9);else return;a.preventDefault()});function r(a,l,c){let{state:h}=e;c?e.change({lampAzimuth:Cg(h.lampAzimuth+a),lampElevation:Fn(h.lampElevation-l,$t.lampElevation.low,$t.lampElevation.high)}):e.change({azimuth:Cg(h.azimuth-a),elevation:Fn(h.elevation+l,$t.elevation.low,$t.elevation.high)})}function o(a){e.change({distance:Fn(e.state.distance*a,$t.distance.low,$t.distance.high)})}}var Cg=i=>((i+180)%360+360)%360-180;function Ig(i){let[e,t]=[...i.values()];return e&&t?Math.hypot(e.x-t.x,e.y-t.y):0}var zc=class{constructor(e){this.payload=e;this.own=[th(e.materials[0]),e.materials[1]?th(e.materials[1]):null],this.materials=[...this.own]}payload;own;materials;get all(){return this.materials}get two(){return this.materials[1]!==null}get cameWithTwo(){return this.own[1]!==null}get firstHours(){return this.materials.map(e=>e?.time?.interval[0]).find(e=>e!==void 0)}at(e){return this.materials[e]??null}active(e){return this.materials[e.active]}shown(e){return e.compare==="one"?[this.active(e)]:[this.materials[0],this.materials[1]]}held(e,t){let n=this.at(t);return n?jf(n,e.values[t]):{}}values(e,t){let n=this.at(t);return n?Qf(n,n.time?e.hours:null,this.held(e,t)):{}}shownValues(e){return e.compare==="one"?[this.values(e,e.active)]:[this.values(e,0),this.values(e,1)]}interval(e){let n=(e.compare==="one"?[this.at(e.active)]:this.materials).flatMap(s=>s?.time?[s.time.interval]:[]);return n.length?[Math.min(...n.map(s=>s[0])),Math.max(...n.map(s=>s[1]))]:null}read(e){return Zf(e,this.payload.library)}follow(e,t){this.materials=[0,1].map(n=>{let s=e.dropped[n];if(!s)return this.own[n];let r=this.materials[n];if(r?.dropped&&JSON.stringify(r.json)===JSON.stringify({...s,name:r.json.name,channels:r.json.channels}))return r;try{return this.read(s).material}catch(o){return t(o),this.own[n]}})}};var kS=4,Hc=class{constructor(e,t){this.hold=e;this.fail=t}hold;fail;element=Ee("div",{class:"motes-parameters"});rows=[];material=null;current={};show(e,t,n){this.current=t,e!==this.material&&this.make(e);for(let{slot:s,sliders:r,state:o}of this.rows){let a=t[s.name],l=s.name in n;for(let{slider:h,channel:u}of r)h.show(u===null?Lg(a)/(Lg(s.value)||1):a[u],l);let c=e.time?.trends[s.name];o.classList.toggle("own",l),o.textContent=l?` · set by hand${c?", no longer follows time":""}`:c?` · follows time: ${c.kind.replaceAll("_"," ")}`:""}}make(e){this.material=e,this.rows=e.slots.map(t=>this.row(e,t)),this.element.replaceChildren(...this.rows.map(({slot:t,sliders:n,state:s})=>Ee("div",{class:"motes-parameter",role:"group","aria-label":`${t.name}: ${t.declared.meaning}`},...n.map(({slider:r})=>r.element),Ee("p",{class:"motes-meaning"},`${t.declared.meaning}, ${HS(t)}`,s))))}row(e,t){let{declared:n}=t,s=Ee("span",{class:"motes-held"}),r=t.value.length,o={symbol:n.symbol,unit:n.unit,hint:n.meaning,reset:()=>this.hold(t.name,null)};if(r>kS){let u=f=>{let p=t.value.map(g=>g*f);for(let g of p)Ma(t,g);this.hold(t.name,p)};return{slot:t,state:s,sliders:[{slider:new Pi({...o,label:`${t.name}, factor for all ${r} channels`,low:0,high:2,set:u},this.fail),channel:null}]}}let[a,l]=zS(t),c=mi(e.channels,e.wavelengths),h=t.value.map((u,f)=>{let p=r>1?` ${e.channels[f]??f+1}`:"",g=m=>{Ma(t,m),this.hold(t.name,this.current[t.name].map((v,A)=>A===f?m:v))},y=r>1?c.find(m=>m.channel===f)?.tint:void 0;return{slider:new Pi({...o,label:`${t.name}${p}`,shown:`${t.name===n.symbol?"":t.name}${p}`,low:a,high:l,set:g,...y?{tint:y}:{}},this.fail),channel:f}});return{slot:t,sliders:h,state:s}}};function zS(i){let{low:e,high:t,open:n,typical:s}=i.declared,r=n&&t!==null?(t-e)*.001:0,o=Math.max(Math.min(s[0],...i.value),e+r),a=Math.min(Math.max(s[1],...i.value.map(l=>l*1.25)),(t??1/0)-r);return[o,a]}function HS(i){let{low:e,high:t,open:n,unit:s}=i.declared,r=t===null?"∞":String(Number(t.toPrecision(4)));return`${n?"(":"["}${e}, ${r}${n||t===null?")":"]"}${s?` ${s}`:""}`}var Lg=i=>i.reduce((e,t)=>e+t,0)/i.length;function Zs(i,e){return Object.fromEntries(i.shader.uniforms.map(t=>{let n=e[t.slot];return[t.name,{value:t.size===1?n[0]:[...n]}]}))}function Gc(i,e){return i.shader.uniforms.map(t=>e&&t.slot===i.tau?`${t.name} * ${e}`:t.name)}function oa(i,e,t,n){return`${i.shader.name}_${e}(${["wi","wo",...Gc(i,t),...n?[n]:[]].join(", ")})`}var GS=i=>i.shader.channels!==1&&i.shader.channels!==3;function VS(i){let{channels:e,stages:t}=i.shader,n=t?"light":"with",s=i.toSrgb.map(o=>`vec3(${o.map(a=>a.toPrecision(9)).map(a=>/[.e]/.test(a)?a:`${a}.0`).join(", ")})`),r="vec3 reflected(vec3 wi, vec3 wo, float share) {";return e===1?`${r}
  return ${oa(i,n,"share","")};
}`:e===3?`${r}
  vec3 f = ${oa(i,n,"share","")};
  return f.x * ${s[0]} + f.y * ${s[1]} + f.z * ${s[2]};
}`:[`const vec3 TO_SRGB[${e}] = vec3[${e}](${s.join(", ")});`,r,`  float f[${e}];`,`  ${oa(i,n,"share","f")};`,"  vec3 sum = vec3(0.0);",`  for (int k = 0; k < ${e}; ++k) sum += f[k] * TO_SRGB[k];`,"  return sum;","}"].join(`
`)}var Ng=`
in float dust;
out vec3 vPosition;
out vec3 vNormal;
out float vDust;
void main() {
  vPosition = position;
  vNormal = normal;
  vDust = dust;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;function Dg(i,e){return`
${i.shader.source}
${e}
${VS(i)}
uniform vec3 lampPosition;
uniform float lampStrength;
uniform sampler2D skyDirections;
uniform int skyFirst;
uniform int skyCount;
uniform float skyStrength;
uniform float painted;
in vec3 vPosition;
in vec3 vNormal;
in float vDust;
out vec4 color;
const float PI = 3.14159265358979;
const float GRAZING = 0.01;
void main() {
  vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
  vec3 view = normalize(cameraPosition - vPosition);
  vec3 side = normalize(cross(abs(normal.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), normal));
  mat3 frame = transpose(mat3(side, cross(normal, side), normal));
  vec3 wo = frame * view;
  // Interpolated normals may turn away from the eye at an outline: such a point is seen at grazing.
  wo = normalize(vec3(wo.xy, max(wo.z, GRAZING)));
  float share = mix(1.0, vDust, painted);
  begin(wo, share);
  vec3 toLamp = lampPosition - vPosition;
  float squared = dot(toLamp, toLamp);
  // lampStrength: the radiance of a white diffuser at the middle that faces the lamp.
  vec3 weight = vec3(PI * lampStrength * dot(lampPosition, lampPosition) / squared);
  vec3 wi = frame * (toLamp * inversesqrt(squared));
  vec3 sum = vec3(0.0);
  // The lamp goes first through the same loop: where a BRDF is written twice, a processor that draws compiles it twice.
  for (int k = skyFirst; k <= skyFirst + skyCount; ++k) {
    if (wi.z > 0.0) sum += reflected(wi, wo, share) * (wi.z * weight);
    int at = 2 * k;
    wi = frame * texelFetch(skyDirections, ivec2(at & 255, at >> 8), 0).xyz;
    weight = texelFetch(skyDirections, ivec2((at + 1) & 255, at >> 8), 0).xyz * (skyStrength / float(max(skyCount, 1)));
  }
  color = vec4(sum, 1.0);
}`}var Vr=`
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;function Fg(i){let{channels:e}=i.shader,t=GS(i)?`float f[${e}];
  ${oa(i,"with","","f")};
  for (int k = 0; k < 4; ++k) if (firstChannel + k < ${e}) found[k] = f[firstChannel + k];`:`found.xyz = ${oa(i,"with","","")};`;return`
${i.shader.source}
uniform sampler2D toLight;
uniform sampler2D toViewer;
uniform int firstChannel;
out vec4 value;
void main() {
  vec3 wi = texelFetch(toLight, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 wo = texelFetch(toViewer, ivec2(gl_FragCoord.xy), 0).xyz;
  vec4 found = vec4(0.0);
  ${t}
  value = found;
}`}var Wr=256,Vc=class{constructor(e){this.renderer=e;this.mesh.frustumCulled=!1,this.scene.add(this.mesh)}renderer;scene=new Yn;camera=new Gn;mesh=new At(new si(2,2));programs=new Map;target=null;evaluate(e,t,n,s){let r=n.length/3,o=e.shader.channels,a=new Float32Array(r*o);if(!r)return a;let l=Math.ceil(r/Wr),[c,h]=[this.texture(n,l),this.texture(s,l)];(!this.target||this.target.height!==l)&&(this.target?.dispose(),this.target=new cn(Wr,l,{type:_t,format:yt,minFilter:Pt,magFilter:Pt,depthBuffer:!1}));let u=this.program(e);Object.assign(u.uniforms,Zs(e,t)),this.mesh.material=u;let f=new Float32Array(4*Wr*l),p=o<=3?3:4;for(let g=0;g<o;g+=p){u.uniforms.toLight={value:c},u.uniforms.toViewer={value:h},u.uniforms.firstChannel={value:g},u.uniformsNeedUpdate=!0,this.renderer.setRenderTarget(this.target),this.renderer.render(this.scene,this.camera),this.renderer.readRenderTargetPixels(this.target,0,0,Wr,l,f);let y=Math.min(p,o-g);for(let m=0;m<r;m+=1)for(let v=0;v<y;v+=1)a[m*o+g+v]=f[4*m+v]}return this.renderer.setRenderTarget(null),c.dispose(),h.dispose(),a}keep(e){for(let[t,n]of this.programs)e.includes(t)||(n.dispose(),this.programs.delete(t))}revive(){this.target=null}program(e){let t=this.programs.get(e);return t||(t=new Ht({glslVersion:wn,vertexShader:Vr,fragmentShader:Fg(e),depthTest:!1,depthWrite:!1}),this.programs.set(e,t)),t}texture(e,t){let n=new Float32Array(4*Wr*t);for(let r=0;r<e.length/3;r+=1)for(let o=0;o<3;o+=1)n[4*r+o]=e[3*r+o];let s=new mn(n,Wr,t,yt,_t);return s.needsUpdate=!0,s}};var Ug=`
out vec3 vDirection;
void main() {
  vDirection = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position + cameraPosition, 1.0);
}`,Og=`
uniform sampler2D sky;
uniform float strength;
in vec3 vDirection;
out vec4 color;
const ivec2 SIZE = ivec2(${pt}, ${Tt});
vec3 cell(ivec2 at) { return texelFetch(sky, ivec2((at.x + SIZE.x) % SIZE.x, clamp(at.y, 0, SIZE.y - 1)), 0).xyz; }
void main() {
  vec3 w = normalize(vDirection);
  vec2 place = vec2(atan(w.x, w.z) / 6.283185307, acos(clamp(w.y, -1.0, 1.0)) / 3.141592654) * vec2(SIZE) - 0.5;
  ivec2 at = ivec2(floor(place));
  vec2 part = place - vec2(at);
  vec3 above = mix(cell(at), cell(at + ivec2(1, 0)), part.x);
  vec3 below = mix(cell(at + ivec2(0, 1)), cell(at + ivec2(1, 1)), part.x);
  color = vec4(mix(above, below, part.y) * strength, 1.0);
}`;function Bg(i){let e=new Float32Array(i.length/3*4);for(let n=0;n<i.length/3;n+=1)e.set(i.subarray(3*n,3*n+3),4*n);let t=new mn(e,pt,Tt,yt,_t);return t.needsUpdate=!0,t}var rs=96,Nt=65,WS=1.1,Wc=6,Cf=16,If=24,$S=.35,XS=`
in float hidden;
out float vHidden;
void main() {
  vHidden = hidden;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`,qS=`
uniform float strength;
in float vHidden;
out vec4 color;
void main() { color = vec4(0.0, 0.0, 0.0, clamp(vHidden * strength, 0.0, 1.0)); }`;function zg(){return new Ht({glslVersion:wn,vertexShader:XS,fragmentShader:qS,side:Zn,depthWrite:!1,uniforms:{strength:{value:1}}})}function Hg(i){let e=i.getAttribute("position").array,t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let S=0;S<e.length;S+=1)t[S%3]=Math.min(t[S%3],e[S]),n[S%3]=Math.max(n[S%3],e[S]);let[s,r]=[(t[0]+n[0])/2,(t[2]+n[2])/2],o=Math.max(n[0]-t[0],n[2]-t[2],.2)/2,a=2*o/rs,[l,c]=[new Float32Array(rs*rs).fill(1/0),new Float32Array(rs*rs).fill(-1/0)],h=(S,w)=>{let[T,E]=[Math.floor((S-s+o)/a),Math.floor((w-r+o)/a)];return E<0||T<0||E>=rs||T>=rs?-1:E*rs+T};YS(e,i.getIndex().array,a,(S,w,T)=>{let E=h(S,T);E<0||(l[E]=Math.min(l[E],w-t[1]),c[E]=Math.max(c[E],w-t[1]))});let u=n[1]-t[1],f=o*(1+WS),p=new Float32Array(3*Nt*Nt),g=new Float32Array(Nt*Nt);for(let S=0;S<Nt*Nt;S+=1){let[w,T]=[2*(S%Nt)/(Nt-1)-1,2*Math.floor(S/Nt)/(Nt-1)-1],[E,x]=[s+w*f,r+T*f];p.set([E,t[1]-.002,x],3*S),Math.hypot(w,T)<1&&(g[S]=A(E,x))}let y=g.map((S,w)=>kg(g,w));for(let S=0;S<g.length;S+=1){let w=Math.hypot(2*(S%Nt)/(Nt-1)-1,2*Math.floor(S/Nt)/(Nt-1)-1);g[S]=kg(y,S)*Math.min(Math.max((1-w)/$S,0),1)}let m=[];for(let S=0;S+1<Nt;S+=1)for(let w=0;w+1<Nt;w+=1){let T=S*Nt+w;m.push(T,T+Nt,T+1,T+1,T+Nt,T+Nt+1)}let v=new Lt;return v.setAttribute("position",new ut(p,3)),v.setAttribute("hidden",new ut(g,1)),v.setIndex(m),v;function A(S,w){let T=0;for(let E=0;E<Wc;E+=1){let x=Math.sqrt((E+.5)/Wc),b=Math.sqrt(1-x*x)/x,L=Math.min(u/b,o+Math.hypot(S-s,w-r))||a;for(let I=0;I<Cf;I+=1){let F=2*Math.PI*(I+E/Wc)/Cf;for(let B=0;B<If;B+=1){let[z,D]=[L*B/If,L*(B+1)/If],W=h(S+Math.sin(F)*(z+D)/2,w+Math.cos(F)*(z+D)/2);if(W>=0&&l[W]<=D*b&&c[W]>=z*b){T+=1;break}}}}return T/(Wc*Cf)}}function kg(i,e){let[t,n]=[0,0];for(let s=Math.max(Math.floor(e/Nt)-1,0);s<=Math.min(Math.floor(e/Nt)+1,Nt-1);s+=1)for(let r=Math.max(e%Nt-1,0);r<=Math.min(e%Nt+1,Nt-1);r+=1)t+=i[s*Nt+r],n+=1;return t/n}function YS(i,e,t,n){for(let r=0;r<e.length;r+=3){let[o,a,l]=[3*e[r],3*e[r+1],3*e[r+2]],c=Math.max(s(o,a),s(a,l),s(l,o)),h=Math.min(Math.max(Math.ceil(c/t),1),rs);for(let u=0;u<=h;u+=1)for(let f=0;f<=h-u;f+=1){let[p,g]=[u/h,f/h],y=m=>i[o+m]+p*(i[a+m]-i[o+m])+g*(i[l+m]-i[o+m]);n(y(0),y(1),y(2))}}function s(r,o){return Math.hypot(i[o]-i[r],i[o+2]-i[r+2])}}var Gg=`
uniform sampler2D before;
uniform sampler2D now;
uniform float share;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = mix(texelFetch(before, at, 0), texelFetch(now, at, 0), share);
}`,Vg=`
uniform sampler2D average;
void main() {
  gl_FragColor = texelFetch(average, ivec2(gl_FragCoord.xy), 0);
  float covered = gl_FragColor.a;
  if (covered > 0.0) gl_FragColor.rgb /= covered;
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  // Eight bits of a smooth slope would show as steps: noise of half a step to either side, the same at every frame, spreads them.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  if (covered > 0.0) gl_FragColor.rgb += noise / 255.0;
  gl_FragColor = vec4(gl_FragColor.rgb * covered, covered);
}`;function Ei(i,e,t){return new cn(i,e,{type:_t,format:yt,minFilter:Pt,magFilter:Pt,depthBuffer:t})}function Pf(i,e,t){return new Ht({glslVersion:e,vertexShader:Vr,fragmentShader:i,uniforms:t,depthTest:!1,depthWrite:!1})}function Lf(i,e){let[t,n,s]=[0,1,i];for(;s>0;)n/=e,t+=n*(s%e),s=Math.floor(s/e);return i===0?0:t-.5}function Wg(i){return i.kept.flatMap(({name:e,type:t})=>t==="bool"?[{read:`(${e} ? 1.0 : 0.0)`,write:s=>`${e} = ${s} > 0.5;`}]:(t==="vec3"?[".x",".y",".z"]:[""]).map(s=>({read:e+s,write:r=>`${e}${s} = ${r};`})))}function $g(i){let{shader:e}=i;if(!e.stages)return"void begin(vec3 wo, float share) {}";let t=Gc(i,"share"),n=`${e.name}_view(${["wo",...t].join(", ")});`;if(!e.kept.length)return`void begin(vec3 wo, float share) {
  ${e.name}_parameters(${t.join(", ")});
  ${n}
}`;let s=Wg(e),r=Array.from({length:Math.ceil(s.length/4)},(o,a)=>[`  row = mix(texelFetch(kept, ivec2(column, ${a}), 0), texelFetch(kept, ivec2(column + 1, ${a}), 0), part);`,...s.slice(4*a,4*a+4).map(({write:l},c)=>`  ${l(`row.${"xyzw"[c]}`)}`)]).flat();return["uniform sampler2D kept;","void begin(vec3 wo, float share) {",`  float place = share > 0.0 ? clamp(pow(share, 1.0 / 3.0) * ${256}.0, 1.0, ${256}.0) : 0.0;`,`  int column = min(int(place), ${255});`,"  float part = place - float(column);","  vec4 row;",...r,`  ${n}`,"}"].join(`
`)}function ZS(i,e,t){let n=new Float32Array(i),s=new Float32Array(4*257*t);for(let o=0;o<257;o+=1)for(let a=0;a<e;a+=1)s[4*(Math.floor(a/4)*257+o)+a%4]=n[o*e+a];let r=new mn(s,257,t,yt,_t);return r.needsUpdate=!0,r}var $c=class{constructor(e){this.material=e;let{shader:t}=e,n=Wg(t),s=Math.ceil(n.length/4),r=Array.from({length:s},(o,a)=>`    case ${a}: value = vec4(${Array.from({length:4},(l,c)=>n[4*a+c]?.read??"0.0").join(", ")}); break;`);this.target=Ei(257,s,!1),this.program=new Ht({glslVersion:wn,vertexShader:Vr,fragmentShader:`${t.source}
out vec4 value;
void main() {
  float share = floor(gl_FragCoord.x) / ${256}.0;
  share *= share * share;
  ${t.name}_parameters(${Gc(e,"share").join(", ")});
  switch (int(gl_FragCoord.y)) {
${r.join(`
`)}
  }
}`,depthTest:!1,depthWrite:!1}),this.quad=new At(new si(2,2),this.program),this.quad.frustumCulled=!1,this.scene.add(this.quad),t.table&&(this.given=ZS(Ni(t.table.data),n.length,s))}material;target;program;scene=new Yn;camera=new Gn;quad;drawn="";given=null;texture(e,t){if(this.given&&this.isGiven(t))return this.given;let n=JSON.stringify(t);return n!==this.drawn&&(Object.assign(this.program.uniforms,Zs(this.material,t)),this.program.uniformsNeedUpdate=!0,e.setRenderTarget(this.target),e.render(this.scene,this.camera),this.drawn=n),this.target.texture}ready(e,t){this.given&&(Object.assign(this.program.uniforms,Zs(this.material,t)),e.setRenderTarget(this.target),e.render(this.scene,this.camera))}isGiven(e){let t=this.material.shader.table?.values??{};return Object.entries(t).every(([n,s])=>s.every((r,o)=>Math.abs(r-(e[n]?.[o]??NaN))<=1e-6*Math.abs(r)))}revive(){this.target=Ei(257,this.target.height,!1),this.drawn=""}dispose(){this.target.dispose(),this.given?.dispose(),this.program.dispose(),this.quad.geometry.dispose()}};var KS={neutral:Lr,agx:Vo,clip:Go},JS=6,Xg=16,jS=2,Nf=64,Df=8,Ff=45,QS=8,ew=120,qg=[60,160],Xc=class{constructor(e){this.canvas=e;let t={antialias:!0,alpha:!0,premultipliedAlpha:!0,preserveDrawingBuffer:!0,powerPreference:"high-performance"},n=e.getContext("webgl2",t);if(!n)throw new oe("This browser has no WebGL 2, which the viewer draws with","Switch on hardware acceleration or try another browser; the pictures below stand in for it");if(!n.getExtension("EXT_color_buffer_float"))throw new oe("This browser cannot draw into floating-point textures, which the viewer needs","Try another browser; the pictures below stand in for it");this.renderer=new Ac({canvas:e,context:n,antialias:!0,alpha:!0,premultipliedAlpha:!0,preserveDrawingBuffer:!0,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.setClearColor(0,0),this.mesh.frustumCulled=!1,this.quad.frustumCulled=!1,this.flat.add(this.quad),this.backdrop=new At(new Po(40,32,16),new Ht({glslVersion:wn,vertexShader:Ug,fragmentShader:Og,side:hn,depthWrite:!1,uniforms:{sky:{value:null},strength:{value:1}}})),this.ground.frustumCulled=!1,this.scene.add(this.backdrop,this.ground,this.mesh),this.sample=Ei(1,1,!0),this.sums=[Ei(1,1,!1),Ei(1,1,!1)]}canvas;renderer;camera=new Kt(30,1,.05,100);scene=new Yn;mesh=new At;backdrop;ground=new At(void 0,zg());groundDue=!0;shownOnce=!1;up=0;own=null;flat=new Yn;flatCamera=new Gn;quad=new At(new si(2,2));averaging=Pf(Gg,wn,{before:{value:null},now:{value:null},share:{value:1}});showing=Pf(Vg,null,{average:{value:null}});shown=[];sample;sums;frame=0;drawn=0;environment="";sky=null;moved=!0;dark=!1;batch=4;coarseness=3;times=[];turning=!1;movedAt=0;row=0;budget=0;stale=!0;lobe=null;setMaterials(e){let t=this.shown;this.shown=e.map(n=>t.find(s=>s.material===n)??{material:n,program:tw(n),kept:n.shader.kept.length?new $c(n):null});for(let n of t)this.shown.includes(n)||Yg(n);this.restart()}setGeometry(e){this.mesh.geometry=e,this.groundDue=!0,this.restart()}resize(e,t,n){let[s,r]=[Math.max(Math.round(e*n),1),Math.max(Math.round(t*n),1)];if(!(this.sample.width===s&&this.sample.height===r)){this.sample.setSize(s,r);for(let o of this.sums)o.setSize(s,r);this.restart()}}setOwn(e){this.own=e,this.environment="",this.restart()}restart(){this.frame=0,this.drawn=0,this.row=0,this.moved=!0}get complete(){return this.frame>=Xg&&(this.dark||this.drawn>=ss)}get progress(){return Math.min(this.frame/Xg,this.dark?1:this.drawn/ss,1)}draw(e,t){e.environment!==this.environment&&this.setEnvironment(e.environment),this.dark=e.environment==="none"||e.sky===0,this.groundDue&&this.shownOnce&&(this.ground.geometry.dispose(),this.ground.geometry=Hg(this.mesh.geometry),this.groundDue=!1,this.shown.forEach(({kept:o},a)=>o?.ready(this.renderer,t[a])));let n=performance.now();if(this.moved)this.movedAt=n;else if(this.coarseness>1&&this.frame===0&&this.row===0&&n-this.movedAt<ew)return;this.adapt();let s=this.moved?this.coarseness:1,r=this.moved||this.complete;if(this.moved&&s>1?this.shade(e,t,...this.size(s),this.batch):this.complete||(r=this.pass(e,t)),r||this.stale&&this.frame>0){let[o,a]=this.fit(s);this.show(e,s===1?this.sums[0]:this.sample,o,a),this.lobe?.draw(this.renderer,this.camera,o,a),this.stale=!1,this.shownOnce=!0}this.moved=!1}size(e){return[Math.ceil(this.sample.width/e),Math.ceil(this.sample.height/e)]}fit(e){let[t,n]=this.size(e);return(this.canvas.width!==t||this.canvas.height!==n)&&this.renderer.setSize(t,n,!1),[t,n]}pass(e,t){let{width:n,height:s}=this.sample,r=Math.min(this.moved?this.batch:Math.min(Math.max(this.drawn,Df),Nf),ss-this.drawn%ss),o=this.moved?s:Math.max(Math.floor(this.budget/r),1),a=Math.min(this.row+o,s);return this.shade(e,t,n,s,r,this.row,a),this.row=a%s,this.row?!1:(this.drawn+=r,this.add(r/this.drawn),this.frame+=1,!0)}shade(e,t,n,s,r,o=0,a=s){let l=this.renderer,c=this.shown.map(({kept:h},u)=>h?.texture(l,t[u])??null);this.place(e,n,s),this.sample.scissor.set(0,o,n,a-o),this.sample.scissorTest=!0,l.setRenderTarget(this.sample),l.clear(),this.parts(e,n).forEach(([h,u,f,p],g)=>{let{material:y,program:m}=this.shown[g];Object.assign(m.uniforms,Zs(y,t[g])),this.light(m,e,r),m.uniforms.kept.value=c[g],this.mesh.material=m,this.sample.viewport.set(f,0,p,s),this.sample.scissor.set(h,o,u,a-o),l.setRenderTarget(this.sample),l.render(this.scene,this.camera)})}radiance(){let{width:e,height:t}=this.sums[0],n=new Float32Array(4*e*t);return this.renderer.readRenderTargetPixels(this.sums[0],0,0,e,t,n),{width:e,height:t,data:n}}revive(){let{width:e,height:t}=this.sample;this.sample=Ei(e,t,!0),this.sums=[Ei(e,t,!1),Ei(e,t,!1)];for(let{kept:n}of this.shown)n?.revive();this.environment="",this.sky=null,this.backdrop.material.uniforms.sky.value=null,this.restart()}dispose(){for(let e of this.shown)Yg(e);for(let e of[this.sample,...this.sums])e.dispose();this.sky?.dispose(),this.ground.geometry.dispose(),this.ground.material.dispose(),this.renderer.dispose()}parts(e,t){if(this.shown.length<2)return[[0,t,0,t]];if(e.compare==="side")return[[0,Math.floor(t/2),0,Math.floor(t/2)],[Math.ceil(t/2),Math.floor(t/2),Math.ceil(t/2),Math.floor(t/2)]];let n=Math.round(t*e.split);return[[0,n,0,t],[n,t-n,0,t]]}place(e,t,n){let[s,r]=[Qt(e.azimuth),Qt(e.elevation)],o=this.shown.length>1&&e.compare==="side"?t/2/n:t/n;this.camera.aspect=o;let a=e.distance*Math.max(1,1/o);this.camera.position.set(Math.sin(s)*Math.cos(r),Math.sin(r),Math.cos(s)*Math.cos(r)).multiplyScalar(a),this.camera.lookAt(0,0,0);let l=[Lf(this.frame,2),Lf(this.frame,3)];this.camera.setViewOffset(t,n,l[0],l[1],t,n),this.camera.updateProjectionMatrix(),this.backdrop.visible=e.backdrop&&e.environment!=="none";let[c,h]=[this.up*e.sky,e.lamp*Math.max(Math.sin(Qt(e.lampElevation)),0)];this.ground.visible=e.ground&&!this.groundDue&&!this.dark&&!this.backdrop.visible,this.ground.material.uniforms.strength.value=c>0?c/(c+h):0}light(e,t,n){let[s,r]=[Qt(t.lampAzimuth),Qt(t.lampElevation)],o=e.uniforms;o.lampPosition.value.set(Math.sin(s)*Math.cos(r),Math.sin(r),Math.cos(s)*Math.cos(r)).multiplyScalar(JS),o.lampStrength.value=t.lamp,o.skyDirections.value=this.sky,o.skyFirst.value=this.drawn%ss,o.skyCount.value=this.dark?0:n,o.skyStrength.value=t.sky,o.painted.value=t.dust?1:0,e.uniformsNeedUpdate=!0,this.backdrop.material.uniforms.strength.value=t.sky}add(e){let t=this.renderer;this.averaging.uniforms.before.value=this.sums[0].texture,this.averaging.uniforms.now.value=this.sample.texture,this.averaging.uniforms.share.value=e,this.quad.material=this.averaging,t.setRenderTarget(this.sums[1]),t.render(this.flat,this.flatCamera),this.sums=[this.sums[1],this.sums[0]]}show(e,t,n,s){let r=this.renderer;r.setRenderTarget(null),r.setScissorTest(!1),r.setViewport(0,0,n,s),r.clear(),r.toneMapping=KS[e.tone]??Lr,r.toneMappingExposure=2**e.exposure,this.showing.uniforms.average.value=t.texture,this.quad.material=this.showing,r.render(this.flat,this.flatCamera)}prepare(e,t,n){this.mesh.geometry=n,this.shade(e,t,1,1,1),this.show(e,this.sample,1,1),this.renderer.getContext().flush()}adapt(){let e=performance.now();if(this.budget||=Df*this.sample.height,this.times.length&&(this.moved!==this.turning||e-this.times.at(-1)>3e3)&&(this.times=[]),this.turning=this.moved,this.times.push(e),this.times.length<(this.moved?6:4))return;let t=(e-this.times[0])/(this.times.length-1);this.times=[],this.moved?t>Ff?this.batch>jS?this.batch/=2:this.coarseness=Math.min(Math.ceil(this.coarseness*Math.min(Math.sqrt(t/Ff),2)),QS):t<Ff/2&&(this.coarseness>1?this.coarseness-=1:this.batch<Nf&&(this.batch*=2)):t>qg[1]?this.budget=Math.max(this.budget/2,Df):t<qg[0]&&(this.budget=Math.min(this.budget*2,Nf*this.sample.height))}setEnvironment(e){this.sky?.dispose();let t=e==="own"?this.own??Gr("studio"):Gr(e);this.up=_g(t),this.sky=yg(t);let n=this.backdrop.material.uniforms;n.sky.value?.dispose(),n.sky.value=Bg(t),this.environment=e}};function Yg({program:i,kept:e}){i.dispose(),e?.dispose()}function tw(i){return new Ht({glslVersion:wn,vertexShader:Ng,fragmentShader:Dg(i,$g(i)),uniforms:{lampPosition:{value:new $},lampStrength:{value:1},skyDirections:{value:null},skyFirst:{value:0},skyCount:{value:0},skyStrength:{value:1},painted:{value:0},kept:{value:null}},side:2})}var nw={sphere:"Sphere",teapot:"Teapot",bunny:"Bunny"},qc=class{constructor(e,t,n,s,r,o){this.store=e;this.start=t;this.fail=n;this.scene=this.sceneSection(s,r),this.compare=this.compareSection(r,o)}store;start;fail;scene;compare;skyName="";followers=[];follow(e){for(let t of this.followers)t(e)}sceneSection(e,t){let n=new Li("Shape",[],a=>this.store.change({shape:a}));this.followers.push(a=>{n.fill(e.names.map(l=>[l,nw[l]??l])),n.show(a.shape)});let s=this.choice("Up","up",[["y","y, as glTF has it"],["z","z, as Blender has it"]]);this.followers.push(a=>s.hidden=!e.isOwn(a.shape));let r=new Li("Surroundings",[],a=>this.store.change({environment:a}));this.followers.push(a=>{r.fill([["studio","Studio"],["sky","Sky"],["dome","White dome"],["none","Nothing"],...this.skyName?[["own",this.skyName]]:[]]),r.show(a.environment)});let o=this.onOff("Dust lies where it settles","dust","tau by inclination and shelter instead of the same everywhere");return this.followers.push(()=>o.hidden=!t.all.some(a=>a?.tau)),di("Scene",!0,Ee("div",{class:"motes-pair"},n.element,r.element),s,this.slider("lamp","lamp",{step:.05}),this.slider("lamp azimuth","lampAzimuth",{unit:"°",step:1}),this.slider("lamp height","lampElevation",{unit:"°",step:1}),this.slider("surroundings","sky",{step:.05}),this.slider("exposure","exposure",{unit:"EV",step:.1}),this.choice("Tone mapping","tone",[["neutral","Khronos PBR Neutral"],["agx","AgX"],["clip","Clip at 1"]]),o,this.onOff("Lobe in the corner","lobe","The BRDF in three dimensions"),this.onOff("Surroundings behind","backdrop","Show the environment as the background"),this.onOff("Ground","ground","The shadow on the ground of the light from all around; without surroundings behind"),Ee("p",{class:"motes-caption"},"Drag to turn, Shift-drag to move the lamp, scroll to zoom. The lamp is a point; light from the surroundings is the sum over up to 1,024 directions, finished some frames after the last change. The ground lacks the light from all around that the shape keeps from it; nothing else casts shadows. A .hdr or .exr panorama that is dropped becomes the surroundings."))}compareSection(e,t){let n=Ee("p",{class:"motes-caption"}),s=this.choice("Show","compare",[["one","One material"],["split","Two, split"],["side","Two, side by side"]]),r=this.slider("where it is split","split",{step:.01});return this.followers.push(o=>{s.querySelector("select").disabled=!e.two,r.hidden=!e.two||o.compare!=="split",n.textContent=e.two?`Left: ${e.at(0).name}. Right: ${e.at(1).name}.`:"Open a second material (a material.json) to compare."}),di("Compare",e.cameWithTwo,s,r,n,t)}slider(e,t,n={}){let s=a=>this.store.change({[t]:iw(e,a,t)}),r=()=>this.store.change({[t]:this.start[t]}),o=new Pi({label:e,...n,...$t[t],set:s,reset:r},this.fail);return this.followers.push(a=>o.show(a[t],a[t]!==this.start[t])),o.element}choice(e,t,n){let s=new Li(e,n,r=>this.store.change({[t]:r}));return this.followers.push(r=>s.show(r[t])),s.element}onOff(e,t,n){let s=new _a(e,r=>this.store.change({[t]:r}),n);return this.followers.push(r=>s.show(r[t])),s.element}};function iw(i,e,t){let{low:n,high:s}=$t[t];if(!Number.isFinite(e))throw new oe(`${i} is not a number`,`Choose one from ${ht(n)} to ${ht(s)}`);return Fn(e,n,s)}async function sw(i){try{await navigator.clipboard.writeText(i);return}catch{let e=Ee("textarea",{"aria-hidden":"true",tabindex:-1,class:"motes-offscreen"});e.value=i,document.body.append(e),e.select();let t=document.execCommand("copy");if(e.remove(),!t)throw new Error("The browser does not let this page copy")}}function Uf(i,e,t="text/plain"){let n=typeof e=="string"?new Blob([e],{type:t}):e,s=URL.createObjectURL(n),r=Ee("a",{href:s,download:i});document.body.append(r),r.click(),r.remove(),setTimeout(()=>URL.revokeObjectURL(s),1e4)}function rw(i){return i.replace(/[^\w.-]+/g,"-").replace(/^[-.]+|[-.]+$/g,"").slice(0,60)||"material"}function ow(i){let e=i;return i.width<i.clientWidth&&(e=Ee("canvas",{width:i.clientWidth,height:i.clientHeight}),e.getContext("2d")?.drawImage(i,0,0,e.width,e.height)),new Promise((t,n)=>e.toBlob(s=>s?t(s):n(new Error("The picture cannot be read"))))}function Zg(i,e,t,n,s,r,o){let a=()=>t.active(i.state),l=f=>`${rw(a().name)}.${f}`,c=()=>{let{state:f}=i;return`${JSON.stringify(ed(a(),t.values(f,f.active),t.held(f,f.active),a().time?f.hours:null),null,1)}
`},h=(f,p)=>()=>{sw(p()).then(()=>s.say(`${f} is copied`),s.fail)},u=f=>{try{history.replaceState(null,"",f)}catch{}h("The link, which restores what you see,",()=>f)()};return di("Take away",!0,Ee("div",{class:"motes-buttons"},$n("Copy material",h("The material",c)),$n("Save material",()=>Uf(l("json"),c(),"application/json")),$n("Copy shader",h("The shader",()=>a().shader.source)),$n("Save shader",()=>Uf(l("glsl"),a().shader.source)),$n("Save picture",()=>{ow(n).then(f=>Uf(l("png"),f),s.fail)}),r?$n("Copy link",()=>u(r())):null,o,$n("Reset all",()=>i.change({...structuredClone(e),dropped:[null,null]}))),Ee("p",{class:"motes-caption"},"Open or drop a material.json, a table of measurements (CSV: theta_i, phi_i, theta_r, phi_r, channels) or a mesh (OBJ, PLY, GLB). Files stay in this page; nothing is sent and nothing is remembered."))}var aw=8,Yc=class{constructor(e,t){this.set=e;this.wake=t;let n=Ii("time");this.button=Ee("button",{type:"button",class:"motes-play","aria-label":"Play",onclick:()=>this.toggle()},"▶"),this.range=Ee("input",{type:"range",id:n,step:"any",class:"motes-range"}),this.range.addEventListener("input",()=>{this.pause(),this.set(Number(this.range.value))}),this.range.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[s.key];if(r===void 0)return;s.preventDefault(),this.pause();let[o,a]=this.interval;this.set(Math.min(Math.max(Number(this.range.value)+r*(a-o)/100,o),a))}),this.element=Ee("div",{class:"motes-transport",role:"group","aria-label":"Time"},this.button,Ee("label",{for:n},"time"),this.range,this.words)}set;wake;element;button;range;words=Ee("output",{class:"motes-hours"});interval=[0,1];playing=!1;last=0;show(e,t){if(this.element.hidden=e===null,!e){this.pause();return}this.interval=e,this.range.min=String(e[0]),this.range.max=String(e[1]),this.range.value=String(t);let n=`${ht(t,3)} h`;this.range.setAttribute("aria-valuetext",n),this.words.textContent=n}toggle(){this.element.hidden||(this.playing?this.pause():(this.playing=!0,this.last=0,Number(this.range.value)>=this.interval[1]&&this.set(this.interval[0]),this.label("Pause","❚❚"),this.wake()))}pause(){this.playing=!1,this.label("Play","▶")}advance(e,t){if(!this.playing)return;let n=this.last?Math.min(e-this.last,200):0;this.last=e;let[s,r]=this.interval,o=t+(r-s)*n/1e3/aw;this.set(o>r?s:o)}label(e,t){this.button.setAttribute("aria-label",e),this.button.textContent=t}};var[lw,cw]=[250,140],Kc=class{element=Ee("div",{class:"motes-trends"});charts=new Map;material=null;update(e,t,n){t!==this.material&&this.make(t);let s=t.time;if(!s)return;let r=s.hours;for(let[o,a]of Object.entries(s.trends)){let l=this.charts.get(o),c=t.slots.find(S=>S.name===o);if(!l||!c)continue;let u=a.values[0].length===1?[{channel:0,tint:"grey"}]:mi(t.channels,t.wavelengths),f=u.map(({channel:S})=>{let w=a.values.map(E=>E[S]),T=a.stderr?a.stderr.map(E=>E[S]??0):null;return{y:w,low:T?w.map((E,x)=>E-1.96*T[x]):w,high:T?w.map((E,x)=>E+1.96*T[x]):w}}),p=a.scans,[g,y]=[Math.min(...f.flatMap(S=>S.low)),Math.max(...f.flatMap(S=>S.high))];if(p)for(let S of p.values)for(let{channel:w}of u){let T=S[w];typeof T=="number"&&([g,y]=[Math.min(g,Math.max(T,g-(y-g))),Math.max(y,Math.min(T,y+(y-g)))])}let m=c.declared;g=Math.max(g,m.low),m.high!==null&&(y=Math.min(y,m.high));let v=(y-g)*.08||Math.abs(y)*.2||.1,A=`${o} over time: ${a.kind}, from ${Zc(a.values[0])} to ${Zc(a.values.at(-1))}; at ${ht(e.hours)} h ${Zc(n[o])}`;l.chart.begin(A,{low:r[0],high:r.at(-1),label:"hours"},{low:g-v,high:y+v,label:`${c.declared.symbol}${c.declared.unit?` (${c.declared.unit})`:""}`}),u.forEach(({channel:S,tint:w},T)=>{let{y:E,low:x,high:b}=f[T];if(a.stderr&&l.chart.band(r,x,b,w),p){let L=p.values.map(F=>F[S]??NaN),I=p.stderr.map(F=>F[S]??NaN);l.chart.bars(p.hours,L.map((F,B)=>F-I[B]),L.map((F,B)=>F+I[B]),w),l.chart.dots(p.hours,L,w)}l.chart.line({x:r,y:E,tint:w})}),l.chart.mark(e.hours),l.words.textContent=`${o}: ${a.kind.replaceAll("_"," ")}, now ${Zc(n[o])}${c.declared.unit?` ${c.declared.unit}`:""}`}}make(e){this.material=e,this.charts.clear();let t=Object.entries(e.time?.trends??{}),n=t.map(([a])=>{let l=new As(`${a} over time`,cw,lw),c=Ee("figcaption",{});return this.charts.set(a,{chart:l,words:c}),Ee("figure",{class:"motes-trend"},c,l.svg)}),s=t.some(([,a])=>a.stderr),r=t.some(([,a])=>a.scans),o=[s?"Bands: 95 %.":"No errors are known, so there are no bands.",r?"Dots: what each scan says on its own, with one standard error.":""].filter(Boolean).join(" ");this.element.replaceChildren(Ee("div",{class:"motes-multiples"},...n),Ee("p",{class:"motes-caption"},o))}},Zc=i=>i.length>4?`${ht(i[0],3)} … ${ht(i.at(-1),3)}`:i.map(e=>ht(e,3)).join(", ");var hw=2,Jc=class{constructor(e,t,n){this.root=e;this.payload=t;this.host=n;Wf(t.models),this.pair=new zc(t),this.meshes=new Bc(t.shapes),this.canvas=Ee("canvas",{tabindex:0,role:"application","aria-label":"The material on a shape. Arrow keys turn it, with Shift the lamp; plus and minus zoom; Space plays time."}),this.picture=new Xc(this.canvas),this.start=nd(t.shapes.shapes[0].name,this.pair.firstHours??0,this.pair.cameWithTwo),this.picture.setMaterials(this.pair.shown(this.start)),this.picture.prepare(this.start,this.pair.shownValues(this.start),this.meshes.get(this.start.shape,this.start.up)),this.data=t.measurement?Rd(t.measurement):null,this.data&&(this.start.incidence=dh(this.data)),this.store=new Sa(structuredClone(this.start)),this.picture.lobe=this.lobe,this.probe=new Vc(this.picture.renderer);let s=r=>this.store.change(r);this.parameters=new Hc((r,o)=>this.store.hold(this.store.state.active,r,o),this.messages.fail),this.reflection=new Pa(s),this.agreement=new Na(s,this.messages.fail),this.transport=new Yc(r=>s({hours:r}),()=>this.request()),this.agreementSection=di("Measured and computed",!0,this.agreement.element),this.trendSection=di("Over time",!0,this.trends.element),this.stage=Ee("div",{class:"motes-stage"},this.canvas,...this.names,this.splitLine,this.progress),this.settings=new qc(this.store,this.start,this.messages.fail,this.meshes,this.pair,Rf("Open second material…",".json",this,!0)),this.build(),Pg(this.canvas,this.store),this.canvas.addEventListener("keydown",r=>{r.key===" "&&(r.preventDefault(),this.transport.toggle())}),this.observer=new ResizeObserver(()=>this.request()),this.observer.observe(this.stage),this.canvas.addEventListener("webglcontextlost",()=>this.contextLost()),this.canvas.addEventListener("webglcontextrestored",()=>this.contextRestored()),Tg(this.root,this,this.stop.signal),this.store.listen(r=>this.follow(r)),n.link&&(this.restore(),addEventListener("hashchange",()=>this.restore(),{signal:this.stop.signal})),this.rebuild(),this.followAll()}root;payload;host;store;start;picture;probe;messages=new kc;firstPicture=0;data=null;pair;meshes;settings;canvas;stage;title=Ee("h1");subtitle=Ee("p",{class:"motes-model"});lobe=new Oc;parameters;reflection;agreement;trends=new Kc;transport;names=[Ee("span",{class:"motes-name left"}),Ee("span",{class:"motes-name right"})];progress=Ee("span",{class:"motes-progress"});tabs=Ee("div",{class:"motes-tabs",role:"group","aria-label":"Which material"});agreementSection;trendSection;splitLine=Ee("div",{class:"motes-cut"});observer;stop=new AbortController;pending=0;plotsDue=!0;lost=!1;material(e){return this.pair.at(e)}values(e){return this.pair.values(this.store.state,e)}evaluate(e,t,n){let s=this.pair.at(e);if(!s)throw new oe(`There is no material ${e}`,"Open a second one");return this.probe.evaluate(s,this.values(e),t,n)}environment(e){return e==="own"?this.picture.own??Gr("none"):Gr(e)}get relativeRms(){return this.agreement.relativeRms}openMaterial(e,t){let n=t?1:this.store.state.active,{material:s,notes:r}=this.pair.read(e),o=[...this.store.state.dropped],a=[...this.store.state.values];o[n]=e,a[n]={};let l=s.time&&!this.pair.interval(this.store.state)?s.time.interval[0]:this.store.state.hours;this.store.change({dropped:o,values:a,hours:l,...n===1?{compare:this.store.state.compare==="one"?"split":this.store.state.compare}:{}}),this.messages.say([`${s.name} is shown: ${s.json.model}`,...r].join(". "))}openData(e){this.data=e,this.messages.say(`${e.name}: ${e.count.toLocaleString("en")} pairs of directions are shown over the material. ${e.note}`.trim()),this.store.change({incidence:dh(e)}),this.followAll()}async openMesh(e,t){let{triangles:n,tau:s}=await this.meshes.add(e,t,this.store.state.up),{active:r}=this.store.state,o=this.pair.active(this.store.state).tau,a=s?o?`. Its own dust lies on it, tau up to ${ht(s)}, which the slider scales`:`. Its own dust, tau up to ${ht(s)}, is not shown: the material has no layer of dust`:"";this.messages.say(`${e} is shown: ${n.toLocaleString("en")} triangles${a}`),this.store.change({shape:e,...s&&o?{dust:!0}:{}}),s&&o&&this.store.hold(r,o,[s]),this.followAll()}openSky(e,t){this.picture.setOwn(t),this.settings.skyName=e,this.messages.say(`${e} lights the scene, as 64 x 128 cells`),this.store.change({environment:"own"}),this.followAll()}link(){return location.href.replace(/#.*$/s,"")+id(this.store.state,this.start)}apply(e){this.store.change(sh(this.start,e))}dispose(){cancelAnimationFrame(this.pending),this.observer.disconnect(),this.stop.abort(),this.transport.pause(),this.picture.dispose(),this.meshes.dispose()}build(){let e=Rf("Open file…",".json,.csv,.txt,.obj,.ply,.glb,.hdr,.exr",this,!1),t=Zg(this.store,this.start,this.pair,this.canvas,this.messages,this.host.link?()=>this.link():null,e);for(let n of[this.settings.scene,this.settings.compare,t])n.classList.add("motes-controls");this.root.replaceChildren(Ee("header",{class:"motes-head"},this.title,this.subtitle,...this.payload.notes.map(n=>Ee("p",{class:"motes-note"},n))),Ee("div",{class:"motes-view"},this.stage,this.transport.element,this.messages.element),Ee("div",{class:"motes-panel"},di("Parameters",!0,this.tabs,this.parameters.element),this.trendSection,di("Reflection",!0,this.reflection.element),this.agreementSection,this.settings.scene,this.settings.compare,t,Ee("p",{class:"motes-foot"},`Motes ${this.payload.motes}. Shaded by GLSL that Motes printed from its equations; f in 1/sr, without the cosine. This page asks the network for nothing.`)))}restore(){let e=sd(location.hash,this.start);if(e){this.store.change(e);let t=[0,1].flatMap(n=>Object.keys(e.values[n]).filter(s=>!Object.hasOwn(this.pair.held(e,n),s)));t.length&&this.messages.fail(new oe(`The link sets ${Ut(t.join(", "))} to what the material cannot have; it is left out`,"Copy the link again"))}!e&&location.hash.startsWith("#motes=")&&this.messages.fail(new oe("The link is damaged and restores nothing","Copy it again"))}rebuild(){this.pair.follow(this.store.state,this.messages.fail),this.probe.keep(this.pair.all),this.tabs.replaceChildren(...this.pair.two?this.pair.all.map((e,t)=>$n(e.name,()=>this.store.change({active:t}),{"data-active":String(t),"aria-pressed":"false"})):[])}followAll(){this.follow(new Set(Object.keys(this.store.state)))}follow(e){e.has("dropped")&&this.rebuild();let{state:t}=this.store;if(!this.pair.two&&(t.compare!=="one"||t.active!==0)){this.store.change({compare:"one",active:0});return}(e.has("shape")||e.has("dropped")||e.has("up"))&&this.picture.setGeometry(this.meshes.get(t.shape,t.up)),["dropped","compare","active"].some(r=>e.has(r))&&this.picture.setMaterials(this.pair.shown(t)),this.settings.follow(t),this.words(t),[...e].every(r=>["exposure","tone","incidence","lobe","radius","scale","active"].includes(r))||this.picture.restart(),this.picture.stale=!0;let s=new Set(["azimuth","elevation","distance","lampAzimuth","lampElevation","lamp","environment","sky","exposure","tone","split","dust","backdrop","ground","up","shape"]);[...e].every(r=>s.has(r))||(this.plotsDue=!0),this.host.changed?.(t),this.request()}words(e){let t=this.pair.shown(e);this.title.textContent=t.map(s=>s.name).join(" and "),this.subtitle.textContent=[...new Set(t.map(s=>s.json.model))].join(" · "),this.names.forEach((s,r)=>{s.hidden=t.length<2,s.textContent=t[r]?.name??""}),this.splitLine.hidden=t.length<2,this.splitLine.style.left=`${100*(e.compare==="side"?.5:e.split)}%`;for(let s of Array.from(this.tabs.children))s.setAttribute("aria-pressed",String(s.getAttribute("data-active")===String(e.active)));let n=this.pair.active(e);this.parameters.show(n,this.values(e.active),this.pair.held(e,e.active)),this.transport.show(this.pair.interval(e),e.hours),this.trendSection.hidden=!n.time,this.agreementSection.hidden=!this.data}request(){!this.pending&&!this.lost&&(this.pending=requestAnimationFrame(e=>this.frame(e)))}frame(e){if(this.pending=0,this.lost)return;this.transport.advance(e,this.store.state.hours);let{state:t}=this.store,n=Math.min(devicePixelRatio||1,hw);if(this.stage.style.setProperty("--aspect",String(this.stage.clientWidth/Math.max(this.stage.clientHeight,1))),this.picture.resize(this.stage.clientWidth,this.stage.clientHeight,n),this.plotsDue&&this.firstPicture&&this.plots(t),this.lobe.visible=t.lobe&&this.firstPicture>0,this.picture.draw(t,this.pair.shownValues(t)),!this.firstPicture){let s=this.picture.renderer.getContext();s.readPixels(0,0,1,1,s.RGBA,s.UNSIGNED_BYTE,new Uint8Array(4)),this.firstPicture=performance.now(),this.root.dataset.firstPicture=this.firstPicture.toFixed(0)}this.progress.textContent=this.picture.complete?"":`${Math.round(100*this.picture.progress)} %`,this.root.dataset.complete=String(this.picture.complete&&!this.plotsDue),(!this.picture.complete||this.plotsDue||this.transport.playing)&&this.request()}plots(e){this.plotsDue=!1,this.picture.stale=!0;let t=this.pair.all.filter(r=>r!==null),n=t.map((r,o)=>this.values(o)),s=t[e.active];if(this.lobe.update(e,s,n[e.active],this.probe),this.reflection.update(e,t,n,this.probe,this.data),this.data)try{this.agreement.update(e,t[0],n[0],this.probe,this.data)}catch(r){this.messages.fail(r)}s.time&&this.trends.update(e,s,n[e.active])}contextLost(){this.lost=!0,cancelAnimationFrame(this.pending),this.pending=0,this.messages.say("The graphics device was lost; the picture comes back with it")}contextRestored(){this.lost=!1,this.picture.revive(),this.probe.revive(),this.plotsDue=!0,this.messages.say("The graphics device is back"),this.request()}};function jg(i,e,t){let n=e;try{if(!ln(e)||e.format!=="motes view"||e.version!==1)throw new oe("The data of this page are of another version of Motes","Write it again with motes view");return i.motes=new Jc(i,n,t),i.motes}catch(s){let[r,o]=s instanceof oe?[s.message,s.hint]:[`The viewer cannot start: ${s instanceof Error?s.message:String(s)}`,"The pictures below stand in for it"];return i.querySelector(".motes-why")?.remove(),i.prepend(Ee("p",{class:"motes-message failed",role:"alert"},`${r}. ${o}.`)),null}}function fw({model:i,el:e}){let t=Ee("div",{class:"motes motes-widget"});e.append(t);let n="",s=jg(t,i.get("payload"),{link:!1,changed:o=>{n=JSON.stringify(o),i.set("state",JSON.parse(n)),i.save_changes()}}),r=()=>{let o=i.get("state");s&&ln(o)&&JSON.stringify(o)!==n&&s.apply(o)};return i.on("change:state",r),()=>{i.off("change:state",r),s?.dispose()}}var Kg=document.getElementById("motes-data"),Jg=document.getElementById("motes");Kg&&Jg&&jg(Jg,JSON.parse(Kg.textContent??"null"),{link:!0});var JC={render:fw};export{JC as default};
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
