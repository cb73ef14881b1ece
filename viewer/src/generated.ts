// Written by tools/viewer_build.py from what Python declares: do not edit.

export interface ParameterDeclaration {
  kind: 'parameter';
  name: string;
  symbol: string;
  unit: string;
  meaning: string;
  value: number;
  low: number;
  high: number | null;
  open: boolean;
  typical: readonly [number, number];
  perChannel: boolean;
  role: string | null;
  advice: string;
}

export interface OptionDeclaration {
  kind: 'option';
  name: string;
  value: string;
  words: readonly string[];
}

export interface ChildDeclaration {
  kind: 'child';
  name: string;
  /** Any model ('brdf'), any Fresnel term ('fresnel'), or the model of that name. */
  accepts: string;
  place: 'term' | 'base' | 'cover' | 'fresnel';
  required: boolean;
  value: string | null;
}

export type FieldDeclaration = ParameterDeclaration | OptionDeclaration | ChildDeclaration;

export interface ModelDeclaration {
  brdf: boolean;
  summary: string;
  fields: readonly FieldDeclaration[];
}

export const MATERIAL_FORMAT = "motes material";
export const MATERIAL_VERSION = 1;
export const LARGEST_MATERIAL = 67108864;
export const SHARES = 257;
export const PAYLOAD_VERSION = 2;

/** Those of Motes itself; a page brings the others that it needs. */
export const MODELS: Record<string, ModelDeclaration> = {
  "lambert": {
    "brdf": true,
    "summary": "A matte surface that looks equally bright from everywhere; its directional albedo is ``K_d``.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_d",
        "symbol": "K_d",
        "unit": "",
        "meaning": "diffuse reflectance",
        "value": 0.5,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "diffuse_colour",
        "advice": ""
      }
    ]
  },
  "oren_nayar": {
    "brdf": true,
    "summary": "V-shaped grooves of Lambertian facets: plaster, clay, cloth, the dry side of paint.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_d",
        "symbol": "K_d",
        "unit": "",
        "meaning": "diffuse reflectance of a facet",
        "value": 0.5,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "diffuse_colour",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "sigma_d",
        "symbol": "σ_d",
        "unit": "rad",
        "meaning": "standard deviation of the facets' slope angle",
        "value": 0.3,
        "low": 0,
        "high": 1.5707963267948966,
        "open": false,
        "typical": [
          0,
          1.5707963267948966
        ],
        "perChannel": false,
        "role": "diffuse_roughness",
        "advice": ""
      }
    ]
  },
  "eon": {
    "brdf": true,
    "summary": "A rough diffuse surface that loses no light: with rho = 1 it reflects all of it at every roughness and angle.",
    "fields": [
      {
        "kind": "parameter",
        "name": "rho",
        "symbol": "\\rho",
        "unit": "",
        "meaning": "colour that the surface has after one reflection; 1 loses no light",
        "value": 0.5,
        "low": 0,
        "high": 1,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "diffuse_colour",
        "advice": "EON is an albedo: scale radiances to at most 1, or take oren_nayar, which allows any K_d"
      },
      {
        "kind": "parameter",
        "name": "r",
        "symbol": "r",
        "unit": "",
        "meaning": "roughness of the diffuse part; 0 is Lambert",
        "value": 0.3,
        "low": 0,
        "high": 1,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": false,
        "role": "diffuse_roughness",
        "advice": ""
      }
    ]
  },
  "torrance_sparrow": {
    "brdf": true,
    "summary": "Mirror-like facets whose tilt theta_h is distributed as exp(-(theta_h/sigma_s)^2).",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_s",
        "symbol": "K_s",
        "unit": "",
        "meaning": "strength of the highlight",
        "value": 0.3,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "highlight_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "sigma_s",
        "symbol": "σ_s",
        "unit": "rad",
        "meaning": "width of the distribution of facet normals",
        "value": 0.15,
        "low": 0.001,
        "high": 1.5707963267948966,
        "open": false,
        "typical": [
          0.02,
          0.8
        ],
        "perChannel": false,
        "role": "highlight_width",
        "advice": ""
      },
      {
        "kind": "option",
        "name": "normalization",
        "value": "printed",
        "words": [
          "printed",
          "facets"
        ]
      },
      {
        "kind": "child",
        "name": "fresnel",
        "accepts": "fresnel",
        "place": "fresnel",
        "required": false,
        "value": null
      }
    ]
  },
  "ggx": {
    "brdf": true,
    "summary": "Mirror-like facets with the long tails of ground glass: most polished, lacquered and metallic surfaces, better than Gaussian ones.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_s",
        "symbol": "K_s",
        "unit": "",
        "meaning": "share of light that facets reflect, or its factor where there is a Fresnel term",
        "value": 0.3,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "highlight_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "alpha",
        "symbol": "\\alpha",
        "unit": "",
        "meaning": "roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",
        "value": 0.2,
        "low": 0.001,
        "high": 1,
        "open": false,
        "typical": [
          0.02,
          0.8
        ],
        "perChannel": false,
        "role": "highlight_width",
        "advice": ""
      },
      {
        "kind": "child",
        "name": "fresnel",
        "accepts": "fresnel",
        "place": "fresnel",
        "required": false,
        "value": null
      },
      {
        "kind": "option",
        "name": "scattering",
        "value": "single",
        "words": [
          "single",
          "multiple"
        ]
      }
    ]
  },
  "beckmann": {
    "brdf": true,
    "summary": "Mirror-like facets whose slopes are Gaussian: the highlight falls off faster than that of `GGX`.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_s",
        "symbol": "K_s",
        "unit": "",
        "meaning": "share of light that facets reflect, or its factor where there is a Fresnel term",
        "value": 0.3,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "highlight_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "alpha",
        "symbol": "\\alpha",
        "unit": "",
        "meaning": "roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",
        "value": 0.2,
        "low": 0.001,
        "high": 1,
        "open": false,
        "typical": [
          0.02,
          0.8
        ],
        "perChannel": false,
        "role": "highlight_width",
        "advice": ""
      },
      {
        "kind": "child",
        "name": "fresnel",
        "accepts": "fresnel",
        "place": "fresnel",
        "required": false,
        "value": null
      },
      {
        "kind": "option",
        "name": "scattering",
        "value": "single",
        "words": [
          "single",
          "multiple"
        ]
      }
    ]
  },
  "gtr": {
    "brdf": true,
    "summary": "Mirror-like facets with a tail that the data choose: enamel, metallic paint, worn metal.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_s",
        "symbol": "K_s",
        "unit": "",
        "meaning": "share of light that facets reflect, or its factor where there is a Fresnel term",
        "value": 0.3,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "highlight_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "alpha",
        "symbol": "\\alpha",
        "unit": "",
        "meaning": "roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",
        "value": 0.2,
        "low": 0.001,
        "high": 1,
        "open": false,
        "typical": [
          0.02,
          0.8
        ],
        "perChannel": false,
        "role": "highlight_width",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "gamma",
        "symbol": "\\gamma",
        "unit": "",
        "meaning": "exponent of the tail of the highlight: 2 is GGX, 1 the longest",
        "value": 2.0,
        "low": 1,
        "high": 10,
        "open": false,
        "typical": [
          1,
          4
        ],
        "perChannel": false,
        "role": "highlight_tail",
        "advice": ""
      },
      {
        "kind": "child",
        "name": "fresnel",
        "accepts": "fresnel",
        "place": "fresnel",
        "required": false,
        "value": null
      }
    ]
  },
  "dust": {
    "brdf": true,
    "summary": "An opaque bed of small particles that scatter once.",
    "fields": [
      {
        "kind": "parameter",
        "name": "w",
        "symbol": "w",
        "unit": "",
        "meaning": "single-scattering albedo of the dust",
        "value": 0.6,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "single_scattering_albedo",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "g",
        "symbol": "g",
        "unit": "",
        "meaning": "mean cosine of the deviation angle",
        "value": 0.0,
        "low": -1,
        "high": 1,
        "open": true,
        "typical": [
          -0.8,
          0.8
        ],
        "perChannel": false,
        "role": "asymmetry",
        "advice": "g > 0 scatters forward, g < 0 backward, 0 evenly"
      },
      {
        "kind": "option",
        "name": "form",
        "value": "brdf",
        "words": [
          "brdf",
          "brightness"
        ]
      },
      {
        "kind": "option",
        "name": "scattering",
        "value": "single",
        "words": [
          "single",
          "multiple"
        ]
      }
    ]
  },
  "dust_layer": {
    "brdf": true,
    "summary": "A layer of dust of optical thickness ``tau`` over a base (Blinn 1982).",
    "fields": [
      {
        "kind": "child",
        "name": "base",
        "accepts": "brdf",
        "place": "base",
        "required": true,
        "value": null
      },
      {
        "kind": "child",
        "name": "dust",
        "accepts": "dust",
        "place": "cover",
        "required": false,
        "value": "dust"
      },
      {
        "kind": "parameter",
        "name": "tau",
        "symbol": "τ",
        "unit": "",
        "meaning": "optical thickness of the layer",
        "value": 0.2,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          2
        ],
        "perChannel": false,
        "role": "depth",
        "advice": ""
      },
      {
        "kind": "option",
        "name": "scattering",
        "value": "single",
        "words": [
          "single",
          "multiple"
        ]
      }
    ]
  },
  "coated_diffuse": {
    "brdf": true,
    "summary": "What comes back from below a gloss: paint, varnished wood, plastic, glazed clay. Its highlight is another model: ``+ GGX(...)``.",
    "fields": [
      {
        "kind": "parameter",
        "name": "rho",
        "symbol": "\\rho",
        "unit": "",
        "meaning": "diffuse reflectance of the body, as seen from inside",
        "value": 0.5,
        "low": 0,
        "high": 1,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "diffuse_colour",
        "advice": "It is an albedo: scale radiances to at most 1, or take lambert, which allows any K_d"
      },
      {
        "kind": "parameter",
        "name": "n",
        "symbol": "n",
        "unit": "",
        "meaning": "refractive index of the body relative to the outside",
        "value": 1.5,
        "low": 1,
        "high": 4,
        "open": false,
        "typical": [
          1.2,
          2
        ],
        "perChannel": false,
        "role": "refractive_index",
        "advice": "Water 1.33, glass and varnish 1.5, diamond 2.4"
      }
    ]
  },
  "hapke": {
    "brdf": true,
    "summary": "An opaque bed of particles: powders, soil, pigments, the surfaces of the Moon and of asteroids.",
    "fields": [
      {
        "kind": "parameter",
        "name": "w",
        "symbol": "w",
        "unit": "",
        "meaning": "single-scattering albedo of the particles",
        "value": 0.6,
        "low": 0,
        "high": 1,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "single_scattering_albedo",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "g",
        "symbol": "g",
        "unit": "",
        "meaning": "mean cosine of the deviation angle",
        "value": -0.2,
        "low": -1,
        "high": 1,
        "open": true,
        "typical": [
          -0.6,
          0.6
        ],
        "perChannel": false,
        "role": "asymmetry",
        "advice": "g > 0 scatters forward, g < 0 backward, 0 evenly"
      },
      {
        "kind": "parameter",
        "name": "B_0",
        "symbol": "B_0",
        "unit": "",
        "meaning": "height of the opposition surge, of what particles scatter back",
        "value": 0.5,
        "low": 0,
        "high": 1,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": false,
        "role": "surge_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "h",
        "symbol": "h",
        "unit": "",
        "meaning": "angular half width of the opposition surge, tan of half the angle between light and viewer",
        "value": 0.06,
        "low": 0.001,
        "high": 1,
        "open": false,
        "typical": [
          0.01,
          0.3
        ],
        "perChannel": false,
        "role": "surge_width",
        "advice": ""
      }
    ]
  },
  "retro": {
    "brdf": true,
    "summary": "Light that goes back to where it came from: a term beside others, ``EON(...) + Retro(...)``, for cloth, road signs and rough minerals.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_r",
        "symbol": "K_r",
        "unit": "",
        "meaning": "share of light that is sent back",
        "value": 0.1,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "further_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "alpha_r",
        "symbol": "\\alpha_r",
        "unit": "",
        "meaning": "width of what is sent back, the roughness alpha of the GGX that would mirror it",
        "value": 0.3,
        "low": 0.001,
        "high": 1,
        "open": false,
        "typical": [
          0.02,
          0.8
        ],
        "perChannel": false,
        "role": "further_width",
        "advice": ""
      }
    ]
  },
  "sheen": {
    "brdf": true,
    "summary": "What velvet, felt and downy surfaces add towards grazing, where they are brightest: a term beside others, ``EON(...) + Sheen(...)``.",
    "fields": [
      {
        "kind": "parameter",
        "name": "K_f",
        "symbol": "K_f",
        "unit": "",
        "meaning": "strength of the fibres; with 1 they return at most as much light as arrives",
        "value": 0.2,
        "low": 0,
        "high": null,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "further_strength",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "a",
        "symbol": "a",
        "unit": "",
        "meaning": "roughness of the fibres: small where they stand upright and shine at grazing angles alone",
        "value": 0.5,
        "low": 0.22,
        "high": 1,
        "open": false,
        "typical": [
          0.22,
          1
        ],
        "perChannel": false,
        "role": "further_width",
        "advice": "Other programs allow less, with more light than arrives"
      }
    ]
  },
  "dielectric": {
    "brdf": false,
    "summary": "Glass, varnish, plastic, water: a real refractive index; exact.",
    "fields": [
      {
        "kind": "parameter",
        "name": "n",
        "symbol": "n",
        "unit": "",
        "meaning": "refractive index relative to the outside",
        "value": 1.5,
        "low": 1,
        "high": 10,
        "open": false,
        "typical": [
          1.02,
          4
        ],
        "perChannel": true,
        "role": "refractive_index",
        "advice": "Water 1.33, glass and varnish 1.5, diamond 2.4"
      }
    ]
  },
  "conductor": {
    "brdf": false,
    "summary": "Metals: a complex refractive index n + ik; exact.",
    "fields": [
      {
        "kind": "parameter",
        "name": "n",
        "symbol": "n",
        "unit": "",
        "meaning": "real part of the refractive index",
        "value": 1.0,
        "low": 0.01,
        "high": 20,
        "open": false,
        "typical": [
          0.05,
          10
        ],
        "perChannel": true,
        "role": "refractive_index",
        "advice": ""
      },
      {
        "kind": "parameter",
        "name": "k",
        "symbol": "k",
        "unit": "",
        "meaning": "extinction coefficient",
        "value": 3.0,
        "low": 0,
        "high": 30,
        "open": false,
        "typical": [
          0,
          15
        ],
        "perChannel": true,
        "role": "extinction",
        "advice": ""
      }
    ]
  },
  "schlick": {
    "brdf": false,
    "summary": "Schlick's approximation from the reflectance at normal incidence: one parameter, good for a fit.",
    "fields": [
      {
        "kind": "parameter",
        "name": "f0",
        "symbol": "f_0",
        "unit": "",
        "meaning": "reflectance at normal incidence",
        "value": 0.04,
        "low": 0,
        "high": 1,
        "open": false,
        "typical": [
          0,
          1
        ],
        "perChannel": true,
        "role": "normal_reflectance",
        "advice": ""
      }
    ]
  }
};

/** A parameter in a material's JSON. */
export interface ParameterJson {
  value: unknown;
  unit: string;
  meaning: string;
}

/** A material as `motes.Material.to_dict` gives it. */
export interface MaterialJson {
  format: string;
  version: number;
  name: string;
  model: string;
  parameters: Record<string, ParameterJson>;
  channels: string[];
  wavelengths_nm: number[];
  trends: Record<string, unknown>;
  time_unit: string;
  conventions: Record<string, string>;
  about: Record<string, unknown>;
}

/** A uniform of a printed shader: its parameter, and how many numbers it holds (1: a float; else a vec3 or an array). */
export interface UniformView {
  name: string;
  slot: string;
  size: number;
}

/** A printed shader: ``name_with(wi, wo, ...)`` takes the uniforms' values in this order. Where it is in `stages`, ``name_parameters(...)`` computes once what parameters alone need, ``name_view(wo, ...)`` what ``name_light(wi, wo, ...)`` needs for each of many lights. Where the first is long, `kept` are its variables, which a table holds instead; `table` is that of the first picture. */
export interface ShaderView {
  source: string;
  name: string;
  uniforms: UniformView[];
  channels: number;
  stages: boolean;
  kept: KeptView[];
  table: KeptTable | null;
}

/** What is kept, at the values that a page begins with: for each share of dust (`SHARES` of them) in turn all numbers of the variables. */
export interface KeptTable {
  values: Record<string, number[]>;
  data: string;
}

/** A global variable of a shader: ``float``, ``vec3`` or ``bool``. */
export interface KeptView {
  name: string;
  type: string;
}

/** What each scan said of a parameter on its own; None where it does not determine it. */
export interface ScansView {
  hours: number[];
  values: ((number | null)[])[];
  stderr: ((number | null)[])[];
}

/** A parameter over the hours of a `TimeView`: values and one standard error, (T, W); None where it is not known. */
export interface TrendView {
  kind: string;
  values: number[][];
  stderr: ((number | null)[])[] | null;
  scans: ScansView | null;
}

/** Trends, evaluated by Python at these times [h]; between them the page takes straight lines. */
export interface TimeView {
  hours: number[];
  interval: [number, number];
  trends: Record<string, TrendView>;
}

/** Where a parameter's values lie; `high` is None where nothing ends them, and `open` means that the ends are none. */
export interface RangeView {
  low: number;
  high: number | null;
  open: boolean;
}

/** A material: its JSON, its printed shader, its course in time, and how its channels become linear sRGB (C, 3). `ranges` are those of its parameters by slot: a model may allow less than the declaration of a parameter, as dust with all orders of scattering does. */
export interface MaterialView {
  json: MaterialJson;
  shader: ShaderView;
  ranges: Record<string, RangeView>;
  time: TimeView | null;
  to_srgb: number[][];
  color: string;
}

/** Measured points. Arrays are base64 of little-endian float32: wi, wo (N, 3), values (T, N, C) with NaN where masked. */
export interface MeasurementView {
  name: string;
  channels: string[];
  hours: number[];
  time_unit: string;
  count: number;
  total: number;
  wi: string;
  wo: string;
  values: string;
  note: string;
}

/** A mesh. Base64 of little-endian numbers: positions uint16 (V, 3) between low and high, normals int16 (V, 3) over 32767, triangles uint16 (F, 3), dust uint8 (V,) over 255: the share of what settles on a level, open surface. */
export interface ShapeView {
  name: string;
  low: [number, number, number];
  high: [number, number, number];
  positions: string;
  normals: string;
  triangles: string;
  dust: string;
}

/** The meshes of the page; and the share of dust that stays on an open surface whose normal makes an angle with up, at equal steps of the angle from 0 to 180 degrees. */
export interface ShapesView {
  shapes: ShapeView[];
  dust_by_inclination: number[];
}

/** All that a page or a widget gets; the library, which only materials that are dropped need, is `deflated`: a dictionary of `ShaderView` by name. */
export interface Payload {
  format: 'motes view';
  version: number;
  motes: string;
  materials: MaterialView[];
  measurement: MeasurementView | null;
  notes: string[];
  library: string;
  models: Record<string, unknown>;
  shapes: ShapesView;
}

/** A map of a parameter. Base64 of little-endian numbers: values and stderr float32 (Y, X, times, channels), NaN where there is none; verdicts uint8, a code for each texel or for each texel and time, of several channels the worst. The spans are the ends of colour scales. */
export interface LayerView {
  name: string;
  doc: string;
  unit: string;
  times: number;
  channels: number;
  values: string;
  stderr: string | null;
  verdicts: string | null;
  span: [number, number];
  error_span: [number, number] | null;
}

/** All that the page of a fitted map gets: every `step`-th texel of rows and columns. Verdicts and statuses by name: the code, the colour; ramp is 256 colours of three bytes. */
export interface MapPayload {
  format: 'motes map';
  version: number;
  motes: string;
  name: string;
  model: string;
  shape: [number, number];
  step: number;
  hours: number[];
  channels: string[];
  to_srgb: number[][];
  color: string;
  ramp: string;
  verdicts: Record<string, [number, string]>;
  statuses: Record<string, [number, string]>;
  status: string;
  residual: LayerView;
  layers: LayerView[];
  notes: string[];
}
