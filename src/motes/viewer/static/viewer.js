function Ee(i,e={},...t){let n=document.createElement(i);return zf(n,e,t),n}function dt(i,e={},...t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);return zf(n,e,t),n}function zf(i,e,t){for(let[n,r]of Object.entries(e))r==null||r===!1||(typeof r=="function"?i.addEventListener(n.slice(2),r):i.setAttribute(n,r===!0?"":String(r)));i.append(...t.filter(n=>n!=null))}function qn(i,e){i.textContent!==e&&(i.textContent=e)}function Hf(i){let[e,t]=i.split("_");return Ee("i",{class:"motes-symbol"},e??"",t?Ee("sub",{},t):null)}var kf=0;function Pi(i){return kf+=1,`motes-${i}-${kf}`}function ut(i,e=4){return Number.isFinite(i)?i!==0&&(Math.abs(i)<.001||Math.abs(i)>=1e5)?i.toExponential(2):String(Number(i.toPrecision(Math.abs(i)<.01?Math.min(e,3):e))):"not a number"}var Un=(i,e,t)=>Math.min(Math.max(i,e),t),pi=i=>i*180/Math.PI,en=i=>i*Math.PI/180;var[u0,f0]=[360,210],Wt={left:52,right:10,top:10,bottom:34},Er=class{constructor(e,t=f0,n=u0){this.height=t;this.width=n;this.title=dt("title",{},e);let r=dt("rect",{x:Wt.left,y:Wt.top-4,width:n-Wt.left-Wt.right,height:t-Wt.top-Wt.bottom+8});this.svg=dt("svg",{viewBox:`0 0 ${n} ${t}`,role:"img",class:"motes-chart"},this.title,dt("defs",{},dt("clipPath",{id:this.clip},r)),this.body)}height;width;svg;title;body=dt("g");x={low:0,high:1,label:""};y={low:0,high:1,label:""};clip=Pi("clip");begin(e,t,n){this.title.textContent=e,this.body.replaceChildren(),this.x=t,this.y=n.high>n.low?n:{...n,high:n.low+1};let r=this.height-Wt.bottom;for(let s of t.ticks??_a(t.low,t.high,this.width>300?6:4)){let o=this.px(s);this.body.append(dt("line",{x1:o,x2:o,y1:Wt.top,y2:r,class:"grid"}),dt("text",{x:o,y:r+14,class:"tick","text-anchor":"middle"},(t.write??ut)(s)))}for(let s of this.y.ticks??_a(this.y.low,this.y.high,4)){let o=this.py(s);this.body.append(dt("line",{x1:Wt.left,x2:this.width-Wt.right,y1:o,y2:o,class:s===0?"axis":"grid"}),dt("text",{x:Wt.left-5,y:o+3.5,class:"tick","text-anchor":"end"},(this.y.write??ut)(s)))}this.body.append(dt("text",{x:(Wt.left+this.width-Wt.right)/2,y:this.height-4,class:"label","text-anchor":"middle"},t.label),dt("text",{x:10,y:(Wt.top+r)/2,class:"label","text-anchor":"middle",transform:`rotate(-90 10 ${(Wt.top+r)/2})`},n.label))}line({x:e,y:t,tint:n,dashed:r}){let s="",o="M";for(let a=0;a<e.length;a+=1){if(!Number.isFinite(t[a])){o="M";continue}s+=`${o}${this.px(e[a]).toFixed(1)} ${this.py(t[a]).toFixed(1)}`,o="L"}this.inside(dt("path",{d:s,class:`line ${n}${r?" dashed":""}`}))}band(e,t,n,r){let s=[];for(let o=0;o<e.length;o+=1)s.push(`${this.px(e[o]).toFixed(1)} ${this.py(n[o]).toFixed(1)}`);for(let o=e.length-1;o>=0;o-=1)s.push(`${this.px(e[o]).toFixed(1)} ${this.py(t[o]).toFixed(1)}`);s.length&&this.inside(dt("path",{d:`M${s.join("L")}Z`,class:`band ${r}`}))}dots(e,t,n){let r="";for(let s=0;s<e.length;s+=1)Number.isFinite(t[s])&&(r+=`M${this.px(e[s]).toFixed(1)} ${this.py(t[s]).toFixed(1)}h0`);r&&this.inside(dt("path",{d:r,class:`dots ${n}`}))}bars(e,t,n,r){let s="";for(let o=0;o<e.length;o+=1)Number.isFinite(t[o])&&Number.isFinite(n[o])&&(s+=`M${this.px(e[o]).toFixed(1)} ${this.py(t[o]).toFixed(1)}V${this.py(n[o]).toFixed(1)}`);s&&this.inside(dt("path",{d:s,class:`bars ${r}`}))}mark(e){this.inside(dt("line",{x1:this.px(e),x2:this.px(e),y1:Wt.top,y2:this.height-Wt.bottom,class:"now"}))}inside(e){e.setAttribute("clip-path",`url(#${this.clip})`),this.body.append(e)}px(e){return Wt.left+(e-this.x.low)/(this.x.high-this.x.low)*(this.width-Wt.left-Wt.right)}py(e){let t=this.height-Wt.bottom;return t-(e-this.y.low)/(this.y.high-this.y.low)*(t-Wt.top)}};function _a(i,e,t){let n=(e-i)/t;if(!(n>0)||!Number.isFinite(n))return[i];let r=10**Math.floor(Math.log10(n)),s=[1,2,2.5,5,10].map(a=>a*r).find(a=>a>=n*.999),o=[];for(let a=Math.ceil(i/s-1e-9);a*s<=e+1e-9*s;a+=1)o.push(Number((a*s).toPrecision(10)));return o}var Li=class{constructor(e,t){this.options=e;let n=Pi("slider"),{low:r,high:s,label:o,unit:a,hint:l}=e,c=e.step??(s-r)/500,h=`${o}${a?`, ${a}`:""}`;this.range=Ee("input",{type:"range",id:n,min:r,max:s,step:"any",class:`motes-range ${e.tint??""}`,title:l,"aria-label":h}),this.number=Ee("input",{type:"number",step:Number(c.toPrecision(1)),class:"motes-number","aria-label":`${h}: number`});let u=p=>{try{e.set(p)}catch(v){t(v),this.show(this.shown,void 0,!0)}};if(this.range.addEventListener("input",()=>u(Number(this.range.value))),this.range.addEventListener("keydown",p=>{let v={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[p.key];if(v===void 0)return;p.preventDefault();let y=(s-r)/100;u(Math.min(Math.max(Number(this.range.value)+v*(e.step??y),r),s))}),this.number.addEventListener("change",()=>u(this.number.value===""?NaN:Number(this.number.value))),e.reset){let p=e.reset;this.button=Ee("button",{type:"button",class:"motes-reset",title:e.resetLabel??"Reset","aria-label":`Reset ${o}`,onclick:()=>p()},"↺")}let f=Ee("label",{for:n,title:l},e.symbol?Hf(e.symbol):null,e.symbol?" ":null,Ee("span",{},e.shown??o),a?Ee("span",{class:"motes-unit"},` ${a}`):null);this.element=Ee("div",{class:"motes-slider"},f,this.range,this.number,this.button)}options;element;range;number;button=null;shown=NaN;show(e,t,n=!1){(e!==this.shown||n)&&(this.shown=e,this.range.value=String(e),this.number.value=ut(e),this.range.setAttribute("aria-valuetext",`${ut(e)}${this.options.unit?` ${this.options.unit}`:""}`)),t!==void 0&&this.button&&(this.button.disabled=!t)}},Ni=class{element;select;filled="";constructor(e,t,n){let r=Pi("choice");this.select=Ee("select",{id:r,onchange:()=>n(this.select.value)}),this.fill(t),this.element=Ee("div",{class:"motes-choice"},Ee("label",{for:r},e),this.select)}fill(e){let t=JSON.stringify(e);if(t===this.filled)return;this.filled=t;let n=this.select.value;this.select.replaceChildren(...e.map(([r,s])=>Ee("option",{value:r},s))),this.show(n)}show(e){Array.from(this.select.options).some(t=>t.value===e)&&(this.select.value=e)}},ya=class{element;box;constructor(e,t,n){this.box=Ee("input",{type:"checkbox",onchange:()=>t(this.box.checked)}),this.element=Ee("label",{class:"motes-switch",title:n},this.box," ",e)}show(e){this.box.checked=e}};function Yn(i,e,t={}){return Ee("button",{type:"button",...t,onclick:()=>e()},i)}function mi(i,e,...t){return Ee("details",{class:"motes-section",open:e},Ee("summary",{},Ee("h2",{},i)),Ee("div",{class:"motes-body"},...t))}var oe=class extends Error{constructor(t,n=""){super(t);this.hint=n;this.name="Problem"}hint};function Bt(i){let e=typeof i=="string"?i:JSON.stringify(i)??String(i);return e.length>60?`${e.slice(0,57)}...`:e}var Kn=Uint8Array,es=Uint16Array,d0=Int32Array,Gf=new Kn([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Vf=new Kn([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),p0=new Kn([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Wf=function(i,e){for(var t=new es(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var r=new d0(t[30]),n=1;n<30;++n)for(var s=t[n];s<t[n+1];++s)r[s]=s-t[n]<<5|n;return{b:t,r}},$f=Wf(Gf,2),Xf=$f.b,m0=$f.r;Xf[28]=258,m0[258]=28;var qf=Wf(Vf,0),g0=qf.b,Dw=qf.r,sh=new es(32768);for(_t=0;_t<32768;++_t)Di=(_t&43690)>>1|(_t&21845)<<1,Di=(Di&52428)>>2|(Di&13107)<<2,Di=(Di&61680)>>4|(Di&3855)<<4,sh[_t]=((Di&65280)>>8|(Di&255)<<8)>>1;var Di,_t,Js=(function(i,e,t){for(var n=i.length,r=0,s=new es(e);r<n;++r)i[r]&&++s[i[r]-1];var o=new es(e);for(r=1;r<e;++r)o[r]=o[r-1]+s[r-1]<<1;var a;if(t){a=new es(1<<e);var l=15-e;for(r=0;r<n;++r)if(i[r])for(var c=r<<4|i[r],h=e-i[r],u=o[i[r]-1]++<<h,f=u|(1<<h)-1;u<=f;++u)a[sh[u]>>l]=c}else for(a=new es(n),r=0;r<n;++r)i[r]&&(a[r]=sh[o[i[r]-1]++]>>15-i[r]);return a}),js=new Kn(288);for(_t=0;_t<144;++_t)js[_t]=8;var _t;for(_t=144;_t<256;++_t)js[_t]=9;var _t;for(_t=256;_t<280;++_t)js[_t]=7;var _t;for(_t=280;_t<288;++_t)js[_t]=8;var _t,Yf=new Kn(32);for(_t=0;_t<32;++_t)Yf[_t]=5;var _t;var v0=Js(js,9,1);var _0=Js(Yf,5,1),ih=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},ti=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},rh=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},y0=function(i){return(i+7)/8|0},Zf=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new Kn(i.subarray(e,t))};var x0=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Zn=function(i,e,t){var n=new Error(e||x0[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Zn),!t)throw n;return n},b0=function(i,e,t,n){var r=i.length,s=n?n.length:0;if(!r||e.f&&!e.l)return t||new Kn(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new Kn(r*3));var c=function(Ve){var ft=t.length;if(Ve>ft){var mt=new Kn(Math.max(ft*2,Ve));mt.set(t),t=mt}},h=e.f||0,u=e.p||0,f=e.b||0,p=e.l,v=e.d,y=e.m,m=e.n,g=r*8;do{if(!p){h=ti(i,u,1);var A=ti(i,u+1,3);if(u+=3,A)if(A==1)p=v0,v=_0,y=9,m=5;else if(A==2){var E=ti(i,u,31)+257,x=ti(i,u+10,15)+4,b=E+ti(i,u+5,31)+1;u+=14;for(var P=new Kn(b),I=new Kn(19),F=0;F<x;++F)I[p0[F]]=ti(i,u+F*3,7);u+=x*3;for(var B=ih(I),z=(1<<B)-1,D=Js(I,B,1),F=0;F<b;){var $=D[ti(i,u,z)];u+=$&15;var M=$>>4;if(M<16)P[F++]=M;else{var q=0,K=0;for(M==16?(K=3+ti(i,u,3),u+=2,q=P[F-1]):M==17?(K=3+ti(i,u,7),u+=3):M==18&&(K=11+ti(i,u,127),u+=7);K--;)P[F++]=q}}var fe=P.subarray(0,E),J=P.subarray(E);y=ih(fe),m=ih(J),p=Js(fe,y,1),v=Js(J,m,1)}else Zn(1);else{var M=y0(u)+4,w=i[M-4]|i[M-3]<<8,T=M+w;if(T>r){l&&Zn(0);break}a&&c(f+w),t.set(i.subarray(M,T),f),e.b=f+=w,e.p=u=T*8,e.f=h;continue}if(u>g){l&&Zn(0);break}}a&&c(f+131072);for(var ae=(1<<y)-1,ce=(1<<m)-1,we=u;;we=u){var q=p[rh(i,u)&ae],De=q>>4;if(u+=q&15,u>g){l&&Zn(0);break}if(q||Zn(2),De<256)t[f++]=De;else if(De==256){we=u,p=null;break}else{var ie=De-254;if(De>264){var F=De-257,Re=Gf[F];ie=ti(i,u,(1<<Re)-1)+Xf[F],u+=Re}var Ue=v[rh(i,u)&ce],ze=Ue>>4;Ue||Zn(3),u+=Ue&15;var J=g0[ze];if(ze>3){var Re=Vf[ze];J+=rh(i,u)&(1<<Re)-1,u+=Re}if(u>g){l&&Zn(0);break}a&&c(f+131072);var me=f+ie;if(f<J){var Xe=s-J,wt=Math.min(J,me);for(Xe+f<0&&Zn(3);f<wt;++f)t[f]=n[Xe+f]}for(;f<me;++f)t[f]=t[f-J]}}e.l=p,e.p=we,e.b=f,e.f=h,p&&(h=1,e.m=y,e.d=v,e.n=m)}while(!h);return f!=t.length&&o?Zf(t,0,f):t.subarray(0,f)};var M0=new Kn(0);var S0=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Zn(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&Zn(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function ar(i,e){return b0(i.subarray(S0(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var oh=typeof TextDecoder<"u"&&new TextDecoder,w0=0;try{oh.decode(M0,{stream:!0}),w0=1}catch{}var A0=function(i){for(var e="",t=0;;){var n=i[t++],r=(n>127)+(n>223)+(n>239);if(t+r>i.length)return{s:e,r:Zf(i,t-1)};r?r==3?(n=((n&15)<<18|(i[t++]&63)<<12|(i[t++]&63)<<6|i[t++]&63)-65536,e+=String.fromCharCode(55296|n>>10,56320|n&1023)):r&1?e+=String.fromCharCode((n&31)<<6|i[t++]&63):e+=String.fromCharCode((n&15)<<12|(i[t++]&63)<<6|i[t++]&63):e+=String.fromCharCode(n)}};function Kf(i,e){if(e){for(var t="",n=0;n<i.length;n+=16384)t+=String.fromCharCode.apply(null,i.subarray(n,n+16384));return t}else{if(oh)return oh.decode(i);var r=A0(i),s=r.s,t=r.r;return t.length&&Zn(8),s}}function gi(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n+=1)t[n]=e.charCodeAt(n);return t.buffer}function Jf(i){return JSON.parse(Kf(ar(new Uint8Array(gi(i)))))}var jf="motes material";var bn={lambert:{brdf:!0,summary:"A matte surface that looks equally bright from everywhere; its directional albedo is ``K_d``.",fields:[{kind:"parameter",name:"K_d",symbol:"K_d",unit:"",meaning:"diffuse reflectance",value:.5,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:""}]},oren_nayar:{brdf:!0,summary:"V-shaped grooves of Lambertian facets: plaster, clay, cloth, the dry side of paint.",fields:[{kind:"parameter",name:"K_d",symbol:"K_d",unit:"",meaning:"diffuse reflectance of a facet",value:.5,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:""},{kind:"parameter",name:"sigma_d",symbol:"σ_d",unit:"rad",meaning:"standard deviation of the facets' slope angle",value:.3,low:0,high:1.5707963267948966,open:!1,typical:[0,1.5707963267948966],perChannel:!1,role:"diffuse_roughness",advice:""}]},eon:{brdf:!0,summary:"A rough diffuse surface that loses no light: with rho = 1 it reflects all of it at every roughness and angle.",fields:[{kind:"parameter",name:"rho",symbol:"\\rho",unit:"",meaning:"colour that the surface has after one reflection; 1 loses no light",value:.5,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:"EON is an albedo: scale radiances to at most 1, or take oren_nayar, which allows any K_d"},{kind:"parameter",name:"r",symbol:"r",unit:"",meaning:"roughness of the diffuse part; 0 is Lambert",value:.3,low:0,high:1,open:!1,typical:[0,1],perChannel:!1,role:"diffuse_roughness",advice:""}]},torrance_sparrow:{brdf:!0,summary:"Mirror-like facets whose tilt theta_h is distributed as exp(-(theta_h/sigma_s)^2).",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"strength of the highlight",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"sigma_s",symbol:"σ_s",unit:"rad",meaning:"width of the distribution of facet normals",value:.15,low:.001,high:1.5707963267948966,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"option",name:"normalization",value:"printed",words:["printed","facets"]},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null}]},ggx:{brdf:!0,summary:"Mirror-like facets with the long tails of ground glass: most polished, lacquered and metallic surfaces, better than Gaussian ones.",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"share of light that facets reflect, or its factor where there is a Fresnel term",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"alpha",symbol:"\\alpha",unit:"",meaning:"roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",value:.2,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},beckmann:{brdf:!0,summary:"Mirror-like facets whose slopes are Gaussian: the highlight falls off faster than that of `GGX`.",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"share of light that facets reflect, or its factor where there is a Fresnel term",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"alpha",symbol:"\\alpha",unit:"",meaning:"roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",value:.2,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},gtr:{brdf:!0,summary:"Mirror-like facets with a tail that the data choose: enamel, metallic paint, worn metal.",fields:[{kind:"parameter",name:"K_s",symbol:"K_s",unit:"",meaning:"share of light that facets reflect, or its factor where there is a Fresnel term",value:.3,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"highlight_strength",advice:""},{kind:"parameter",name:"alpha",symbol:"\\alpha",unit:"",meaning:"roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",value:.2,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"highlight_width",advice:""},{kind:"parameter",name:"gamma",symbol:"\\gamma",unit:"",meaning:"exponent of the tail of the highlight: 2 is GGX, 1 the longest",value:2,low:1,high:10,open:!1,typical:[1,4],perChannel:!1,role:"highlight_tail",advice:""},{kind:"child",name:"fresnel",accepts:"fresnel",place:"fresnel",required:!1,value:null}]},dust:{brdf:!0,summary:"An opaque bed of small particles that scatter once.",fields:[{kind:"parameter",name:"w",symbol:"w",unit:"",meaning:"single-scattering albedo of the dust",value:.6,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"single_scattering_albedo",advice:""},{kind:"parameter",name:"g",symbol:"g",unit:"",meaning:"mean cosine of the deviation angle",value:0,low:-1,high:1,open:!0,typical:[-.8,.8],perChannel:!1,role:"asymmetry",advice:"g > 0 scatters forward, g < 0 backward, 0 evenly"},{kind:"option",name:"form",value:"brdf",words:["brdf","brightness"]},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},dust_layer:{brdf:!0,summary:"A layer of dust of optical thickness ``tau`` over a base (Blinn 1982).",fields:[{kind:"child",name:"base",accepts:"brdf",place:"base",required:!0,value:null},{kind:"child",name:"dust",accepts:"dust",place:"cover",required:!1,value:"dust"},{kind:"parameter",name:"tau",symbol:"τ",unit:"",meaning:"optical thickness of the layer",value:.2,low:0,high:null,open:!1,typical:[0,2],perChannel:!1,role:"depth",advice:""},{kind:"option",name:"scattering",value:"single",words:["single","multiple"]}]},coated_diffuse:{brdf:!0,summary:"What comes back from below a gloss: paint, varnished wood, plastic, glazed clay. Its highlight is another model: ``+ GGX(...)``.",fields:[{kind:"parameter",name:"rho",symbol:"\\rho",unit:"",meaning:"diffuse reflectance of the body, as seen from inside",value:.5,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"diffuse_colour",advice:"It is an albedo: scale radiances to at most 1, or take lambert, which allows any K_d"},{kind:"parameter",name:"n",symbol:"n",unit:"",meaning:"refractive index of the body relative to the outside",value:1.5,low:1,high:4,open:!1,typical:[1.2,2],perChannel:!1,role:"refractive_index",advice:"Water 1.33, glass and varnish 1.5, diamond 2.4"}]},hapke:{brdf:!0,summary:"An opaque bed of particles: powders, soil, pigments, the surfaces of the Moon and of asteroids.",fields:[{kind:"parameter",name:"w",symbol:"w",unit:"",meaning:"single-scattering albedo of the particles",value:.6,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"single_scattering_albedo",advice:""},{kind:"parameter",name:"g",symbol:"g",unit:"",meaning:"mean cosine of the deviation angle",value:-.2,low:-1,high:1,open:!0,typical:[-.6,.6],perChannel:!1,role:"asymmetry",advice:"g > 0 scatters forward, g < 0 backward, 0 evenly"},{kind:"parameter",name:"B_0",symbol:"B_0",unit:"",meaning:"height of the opposition surge, of what particles scatter back",value:.5,low:0,high:1,open:!1,typical:[0,1],perChannel:!1,role:"surge_strength",advice:""},{kind:"parameter",name:"h",symbol:"h",unit:"",meaning:"angular half width of the opposition surge, tan of half the angle between light and viewer",value:.06,low:.001,high:1,open:!1,typical:[.01,.3],perChannel:!1,role:"surge_width",advice:""}]},retro:{brdf:!0,summary:"Light that goes back to where it came from: a term beside others, ``EON(...) + Retro(...)``, for cloth, road signs and rough minerals.",fields:[{kind:"parameter",name:"K_r",symbol:"K_r",unit:"",meaning:"share of light that is sent back",value:.1,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"further_strength",advice:""},{kind:"parameter",name:"alpha_r",symbol:"\\alpha_r",unit:"",meaning:"width of what is sent back, the roughness alpha of the GGX that would mirror it",value:.3,low:.001,high:1,open:!1,typical:[.02,.8],perChannel:!1,role:"further_width",advice:""}]},sheen:{brdf:!0,summary:"What velvet, felt and downy surfaces add towards grazing, where they are brightest: a term beside others, ``EON(...) + Sheen(...)``.",fields:[{kind:"parameter",name:"K_f",symbol:"K_f",unit:"",meaning:"strength of the fibres; with 1 they return at most as much light as arrives",value:.2,low:0,high:null,open:!1,typical:[0,1],perChannel:!0,role:"further_strength",advice:""},{kind:"parameter",name:"a",symbol:"a",unit:"",meaning:"roughness of the fibres: small where they stand upright and shine at grazing angles alone",value:.5,low:.22,high:1,open:!1,typical:[.22,1],perChannel:!1,role:"further_width",advice:"Other programs allow less, with more light than arrives"}]},dielectric:{brdf:!1,summary:"Glass, varnish, plastic, water: a real refractive index; exact.",fields:[{kind:"parameter",name:"n",symbol:"n",unit:"",meaning:"refractive index relative to the outside",value:1.5,low:1,high:10,open:!1,typical:[1.02,4],perChannel:!0,role:"refractive_index",advice:"Water 1.33, glass and varnish 1.5, diamond 2.4"}]},conductor:{brdf:!1,summary:"Metals: a complex refractive index n + ik; exact.",fields:[{kind:"parameter",name:"n",symbol:"n",unit:"",meaning:"real part of the refractive index",value:1,low:.01,high:20,open:!1,typical:[.05,10],perChannel:!0,role:"refractive_index",advice:""},{kind:"parameter",name:"k",symbol:"k",unit:"",meaning:"extinction coefficient",value:3,low:0,high:30,open:!1,typical:[0,15],perChannel:!0,role:"extinction",advice:""}]},schlick:{brdf:!1,summary:"Schlick's approximation from the reflectance at normal incidence: one parameter, good for a fit.",fields:[{kind:"parameter",name:"f0",symbol:"f_0",unit:"",meaning:"reflectance at normal incidence",value:.04,low:0,high:1,open:!1,typical:[0,1],perChannel:!0,role:"normal_reflectance",advice:""}]}};var xa=/\s*([A-Za-z_]\w*|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|'[^']*'|"[^"]*"|[()[\],=+])/y,Qf=64,ed=2e4;function nd(i){Object.assign(bn,i)}function ba(i){let e=bn[i]?.fields.find(t=>t.kind==="child"&&t.place==="base");return e?.kind==="child"?e:null}function ah(i){if(i.length>ed)throw new oe(`The model's text has ${i.length} characters`,`It may have ${ed}`);let e=T0(i),t=0,n=0,r=()=>{throw new oe(`The model ${Bt(i)} is not a sum of models`,`The models are ${Object.keys(bn).join(", ")}`)},s=()=>e[t],o=v=>{let y=e[t];return y===void 0||v!==void 0&&y!==v?r():(t+=1,y)},a=()=>{let v=l();for(;s()==="+";)o(),v={kind:"sum",a:v,b:l()};return v},l=()=>{if(s()==="("){o();let v=a();return o(")"),v}return c(o())},c=v=>{let y=Object.hasOwn(bn,v)?bn[v]:void 0;if(!y)throw new oe(`${Bt(v)} is not a model`,`The models are ${Object.keys(bn).join(", ")}`);if(n+=1,n>Qf)throw new oe(`The model has more than ${Qf} parts`,"Write a shorter one");let m=id(v),g=new Map(y.fields.map(w=>[w.name,w]));if(s()!=="(")return td(m);o("(");let A=y.fields.filter(w=>w.kind==="child"&&w.place!=="fresnel"),M=new Set;for(;s()!==")";){let w=/^[A-Za-z_]/.test(s()??"")&&e[t+1]==="="?o():A[M.size]?.name??r();s()==="="&&o();let T=g.get(w);if(!T||M.has(w))throw new oe(`${v} has no ${Bt(w)} (or it is given twice)`,`It has ${[...g.keys()].join(", ")}`);M.add(w),T.kind==="parameter"?m.values[w]=h():T.kind==="option"?m.options[w]=f(T.words,`${v}: ${w}`):m.children[w]=E0(T,a(),v),s()!==")"&&o(",")}return o(")"),td(m)},h=()=>{if(!(s()==="["||s()==="("))return[u(o())];o();let y=[u(o())];for(;s()===",";)o(),y.push(u(o()));return o(),y},u=v=>Number.isFinite(Number(v))?Number(v):r(),f=(v,y)=>{let m=o().replace(/^['"]|['"]$/g,"");if(!v.includes(m))throw new oe(`${y} = ${Bt(m)} is not one of ${v.join(", ")}`,"Correct the model");return m},p=a();if(t<e.length&&r(),p.kind==="named"&&!bn[p.name]?.brdf)throw new oe(`${p.name} is a Fresnel term, not a BRDF`,"Use it as torrance_sparrow(fresnel=...)");return p}function id(i){let e={kind:"named",name:i,options:{},children:{},values:{}};for(let t of bn[i].fields)t.kind==="option"&&(e.options[t.name]=t.value),t.kind==="child"&&(e.children[t.name]=t.value?id(t.value):null),t.kind==="parameter"&&(e.values[t.name]=[t.value]);return e}function T0(i){let e=[];xa.lastIndex=0;let t=i.trimEnd();for(;xa.lastIndex<t.length;){let n=xa.lastIndex,r=xa.exec(t);if(!r)throw new oe(`The model ${Bt(i)} cannot be read from ${Bt(i.slice(n,n+20))} on`,"Write for example oren_nayar + torrance_sparrow");e.push(r[1])}return e}function E0(i,e,t){let n=i.accepts==="brdf"||i.accepts==="fresnel";if(!(e.kind==="sum"?i.accepts==="brdf":n?i.accepts==="brdf"===bn[e.name]?.brdf:i.accepts===e.name))throw new oe(`${t}: ${i.name} is not a ${i.accepts}`,"Correct the model");return e}function td(i){for(let e of bn[i.name].fields){if(e.kind!=="child")continue;let t=i.children[e.name];if(e.required&&!t)throw new oe(`${i.name} has no ${e.name}`,`Write ${i.name}(oren_nayar), say`);if(!(e.place!=="cover"||t?.kind!=="named")){for(let n of bn[t.name].fields)if(n.kind==="option"&&t.options[n.name]!==n.value)throw new oe(`The ${e.name} of ${i.name} must have the ${n.name} ${n.value}`,`Leave its ${n.name} out`)}}return i}function lh(i){let e=new Map,t=[],n=r=>{if(r.kind==="sum"){n(r.a),n(r.b);return}for(let s of bn[r.name].fields)if(s.kind==="parameter"){let o=(e.get(s.name)??0)+1;e.set(s.name,o),t.push({name:o===1?s.name:`${s.name}_${o}`,declared:s,value:r.values[s.name]})}else if(s.kind==="child"){let o=r.children[s.name];o&&n(o)}};return n(i),t}var Ma="motes_eval";function sd(i,e,t,n){let r=new Set,s=0,o=v=>{let y=t[v];if(!y)throw new oe(`This page holds no shader for ${v}`,"Write a page of its own: motes view MATERIAL");return r.add(v),y},a=v=>{let y=e[s];return s+=1,v>1&&y.value.length===1?`vec3(${y.name})`:y.name},l=(v,y)=>{let m=o(v),g=m.uniforms.slice(y.length).map(A=>a(A.size));return`${m.name}_with(wi, wo, ${[...y,...g].join(", ")})`},c=v=>{if(v.kind==="sum")return`(${c(v.a)} + ${c(v.b)})`;let y=ba(v.name);if(!y)return l(rd(v),[]);let m=c(v.children[y.name]);return l(rd(v),[`3.14159265358979 * ${m}`])},h=c(i),u=e.map(v=>({name:`motes_${v.name}`,slot:v.name,size:v.value.length})),f=v=>v===1?"float":"vec3";return{source:[`// ${n.replace(/[^ -~]|\\|\*\//g," ")}`,"// Put together by the viewer from shaders that Motes printed from its equations, one for each model.","",...[...r].map(v=>t[v].source),...u.map(v=>`uniform ${f(v.size)} ${v.name};`),"",`vec3 ${Ma}_with(vec3 wi, vec3 wo${e.map(v=>`, ${f(v.value.length)} ${v.name}`).join("")}) {`,`    return ${h};`,"}","",`vec3 ${Ma}(vec3 wi, vec3 wo) {`,`    return ${Ma}_with(wi, wo${u.map(v=>`, ${v.name}`).join("")});`,"}",""].join(`
`),name:Ma,uniforms:u,channels:Math.max(...e.map(v=>v.value.length)),stages:!1,kept:[],table:null}}function rd(i){let e=bn[i.name].fields.flatMap(t=>{if(t.kind==="option")return[i.options[t.name]];let n=t.kind==="child"&&t.place==="fresnel"?i.children[t.name]:null;return n&&n.kind==="named"?[n.name]:[]});return[i.name,...e].join("_")}var R0=200;function ch(i){let e=ah(i.json.model),t=lh(e);for(let r of t)r.value=hh(i.json.parameters[r.name]?.value,r.name),r.declared={...r.declared,...i.ranges[r.name]};if(i.shader.uniforms.map(r=>r.slot).join()!==t.map(r=>r.name).join())throw new oe("The shader and the model of this page disagree","Write the page again with motes view");for(let[r,s]of i.shader.uniforms.entries())t[r].value=uh(t[r].value,s.size);return ld(i.json,e,t,i.shader,i.time,i.to_srgb,i.color,!1)}function ad(i,e){if(!hn(i)||i.format!==jf)throw new oe(`This JSON is not a Motes material: its format is ${Bt(hn(i)?i.format:i)}`,"motes fit DATA -o OUT writes one");let t=i.version;if(typeof t!="number"||!Number.isInteger(t)||t>1)throw new oe(`The material's version ${Bt(t)} is newer than ${1}, which this page reads`,"Write the page again with a newer Motes");let n=ah(String(i.model)),r=lh(n),s=hn(i.parameters)?i.parameters:{};for(let v of Object.keys(s))if(!r.some(y=>y.name===v))throw new oe(`The model ${Bt(i.model)} has no parameter ${Bt(v)}`,`It has ${r.map(y=>y.name).join(", ")}`);for(let v of r){let y=s[v.name];if(!hn(y))throw new oe(`The material has no value for ${v.name}`,"Write it again with motes fit");v.value=hh(y.value,v.name);for(let m of v.value)Sa(v,m);if(v.value.length>1&&!v.declared.perChannel)throw new oe(`${v.name} has ${v.value.length} values; it is one for all channels`,"Correct the material")}let o=Math.max(...r.map(v=>v.value.length));if(o!==1&&o!==3)throw new oe(`The material has ${o} channels; one or three can be dropped onto a page`,"motes view MATERIAL writes a page for any number");for(let v of r)if(v.value.length!==1&&v.value.length!==o)throw new oe(`${v.name} has ${v.value.length} values and the material ${o} channels`,"Correct the material");let a=String(i.name??"material").slice(0,R0),l=Array.isArray(i.channels)&&i.channels.length===o?i.channels.map(String):o===3?["R","G","B"]:["grey"],c=o===1?[[1,1,1]]:[[1,0,0],[0,1,0],[0,0,1]],h=[],u=C0(i.trends,r,a,h),f={...i,name:a,channels:l},p=o===3?"the three channels are shown as linear sRGB":"shown in grey";return{material:ld(f,n,r,sd(n,r,e,a),u,c,p,!0),notes:h}}function ld(i,e,t,n,r,s,o,a){let c=(e.kind==="named"&&ba(e.name)?t.filter(h=>h.declared.role==="depth"):[]).at(-1)?.name??null;return{name:i.name,model:e,slots:t,shader:n,time:r,toSrgb:s,color:o,channels:i.channels,wavelengths:i.wavelengths_nm??[],json:i,tau:c,dropped:a}}function C0(i,e,t,n){if(!hn(i)||!Object.keys(i).length)return null;let r=Object.entries(i).flatMap(([l,c])=>{let h=hn(c)&&c.kind==="tabulated"?c:null,u=h&&Array.isArray(h.hours)?h.hours.map(Number):[],f=h&&Array.isArray(h.values)?h.values.map(y=>hh(y,l)):[],p=e.find(y=>y.name===l)?.value.length;return u.length>1&&u.length===f.length&&u.every((y,m)=>Number.isFinite(y)&&(m===0||y>u[m-1]))&&f.every(y=>y.length===p||y.length===1)&&p?[{slot:l,hours:u,values:f.map(y=>uh(y,p))}]:[]});if(r.length<Object.keys(i).length&&n.push(`${t} follows time; a dropped material shows its first moment, for the formulas of its trends are in Python: motes view MATERIAL writes a page that plays it.`),r.length<Object.keys(i).length||!r.length)return null;let s=[Math.min(...r.map(l=>l.hours[0])),Math.max(...r.map(l=>l.hours.at(-1)))],o=[...new Set(r.flatMap(l=>l.hours))].sort((l,c)=>l-c),a=l=>o.map(c=>cd(l.hours,l.values,c));return{hours:o,interval:s,trends:Object.fromEntries(r.map(l=>[l.slot,{kind:"tabulated",values:a(l),stderr:null,scans:null}]))}}function cd(i,e,t){if(t<=i[0])return e[0];if(t>=i.at(-1))return e.at(-1);let n=0,r=i.length-1;for(;r-n>1;){let o=n+r>>1;i[o]<=t?n=o:r=o}let s=(t-i[n])/(i[r]-i[n]);return e[n].map((o,a)=>o+s*(e[r][a]-o))}function hd(i,e){let t=n=>Object.hasOwn(e,n.name)&&e[n.name].length===n.value.length&&e[n.name].every(r=>dd(n,r));return Object.fromEntries(i.slots.filter(t).map(n=>[n.name,e[n.name]]))}function ud(i,e,t){let n={};for(let r of i.slots){let s=i.time?.trends[r.name],o=s&&e!==null?uh(cd(i.time.hours,s.values,e),r.value.length):r.value;n[r.name]=t[r.name]??o}return n}function fd(i,e,t,n){let r=Object.fromEntries(i.slots.map(l=>{let c=e[l.name],h=c.length===1&&!Array.isArray(i.json.parameters[l.name]?.value);return[l.name,{value:h?c[0]:c,unit:l.declared.unit,meaning:l.declared.meaning}]})),s=Object.fromEntries(Object.entries(i.json.trends??{}).filter(([l])=>!(l in t))),o=Object.keys(t),a={...i.json.about,...o.length?{viewer:`set by hand: ${o.join(", ")}`}:{},...Object.keys(s).length&&n!==null?{viewer_hours:n}:{}};return{...i.json,parameters:r,trends:s,about:a}}function dd(i,e){let{low:t,high:n,open:r}=i.declared,s=n??1/0;return Number.isFinite(e)&&(r?e>t&&e<s:e>=t&&e<=s)}function Sa(i,e){if(dd(i,e))return;let{low:t,high:n,open:r,unit:s,meaning:o,advice:a}=i.declared,l=`${r?"(":"["}${t}, ${n===null?"inf)":`${Number(n.toFixed(4))}${r?")":"]"}`}${s?` ${s}`:""}`;throw new oe(`${i.name} = ${e} is outside ${l} (${o})`,a||(s==="rad"?"Angles are in radians":`Choose a value in ${l}`))}function hh(i,e){let t=Array.isArray(i)?i.flat(4):[i];if(!t.length||!t.every(n=>typeof n=="number"&&Number.isFinite(n)))throw new oe(`${e} = ${Bt(i)} is not a number or a list of numbers`,"Correct the material");return t}var uh=(i,e)=>i.length===1&&e>1?Array(e).fill(i[0]):i,hn=i=>typeof i=="object"&&i!==null&&!Array.isArray(i);var $t={azimuth:{low:-180,high:180},elevation:{low:-89,high:89},distance:{low:1.5,high:30},lampAzimuth:{low:-180,high:180},lampElevation:{low:-30,high:90},lamp:{low:0,high:4},sky:{low:0,high:4},exposure:{low:-6,high:6},split:{low:.05,high:.95},incidence:{low:0,high:88},hours:{low:-1e9,high:1e9},active:{low:0,high:1}},I0={up:["y","z"],environment:["sky","studio","dome","none","own"],tone:["neutral","agx","clip"],compare:["one","side","split"],radius:["f","f cos"],scale:["linear","cube root"]};function pd(i,e,t){return{values:[{},{}],dropped:[null,null],active:0,hours:e,shape:i,azimuth:0,elevation:12,distance:5.2,lampAzimuth:-45,lampElevation:40,lamp:.9,environment:"studio",sky:.8,exposure:0,tone:"neutral",compare:t?"split":"one",split:.5,dust:!0,lobe:!0,backdrop:!1,ground:!0,up:"y",incidence:45,radius:"f",scale:"linear"}}var P0=100;function md(i,e){let t=Object.fromEntries(Object.entries(i).filter(([r,s])=>JSON.stringify(s)!==JSON.stringify(e[r])));if(!Object.keys(t).length)return"";let n=new TextEncoder().encode(JSON.stringify(t));return`#motes=${btoa(Array.from(n,r=>String.fromCharCode(r)).join("")).replace(/\+/g,"-").replace(/\//g,"_").replace(/=+$/,"")}`}function gd(i,e){let t=/^#motes=([\w-]+)$/.exec(i);if(!t)return null;try{let n=atob(t[1].replace(/-/g,"+").replace(/_/g,"/")),r=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(Uint8Array.from(n,s=>s.charCodeAt(0))));return hn(r)?fh(e,r):null}catch{return null}}function fh(i,e){let t=structuredClone(i),n=t;for(let[r,s]of Object.entries($t))typeof e[r]=="number"&&Number.isFinite(e[r])&&(n[r]=Un(e[r],s.low,s.high));for(let[r,s]of Object.entries(I0))typeof e[r]=="string"&&s.includes(e[r])&&(n[r]=e[r]);for(let r of["dust","lobe","backdrop","ground"])typeof e[r]=="boolean"&&(n[r]=e[r]);typeof e.shape=="string"&&(t.shape=e.shape.slice(0,P0)),t.active=Math.round(t.active);for(let r of[0,1]){let s=Array.isArray(e.values)?e.values[r]:null;if(hn(s)){t.values[r]={};for(let[a,l]of Object.entries(s))Array.isArray(l)&&l.every(c=>typeof c=="number"&&Number.isFinite(c))&&(t.values[r][a]=l)}let o=Array.isArray(e.dropped)?e.dropped[r]:null;hn(o)&&(t.dropped[r]=o)}return t}var wa=class{constructor(e){this.state=e}state;listeners=new Set;listen(e){this.listeners.add(e)}change(e){let t=Object.keys(e).filter(r=>JSON.stringify(e[r])!==JSON.stringify(this.state[r]));if(!t.length)return;this.state={...this.state,...e};let n=new Set(t);for(let r of this.listeners)r(n)}hold(e,t,n){let r=[{...this.state.values[0]},{...this.state.values[1]}],s=r[e];n?s[t]=n:delete s[t],this.change({values:r})}};var Zt={angles:{phase:["phase","phase_angle"],theta_i:["theta_i","inc","theta_in","theta_inc","theta_incident","theta_incidence","theta_l","theta_light","theta_source","theta_sun","theta_illumination","i_theta","in_theta","incidence_angle","incident_angle","angle_of_incidence","aoi","incidence","incident_theta","incident_zenith","incidence_zenith","illumination_zenith","illumination_angle","light_zenith","light_theta","light_angle","source_zenith","source_angle","lamp_zenith","lamp_angle","sun_zenith","solar_zenith","solar_zenith_angle","sun_zenith_angle","sza","zenith_i","zenith_in","polar_i","polar_in"],phi_i:["phi_i","phi_in","phi_inc","phi_incident","phi_incidence","phi_l","phi_light","phi_source","phi_sun","i_phi","in_phi","incidence_azimuth","incident_azimuth","incident_phi","illumination_azimuth","light_azimuth","light_phi","source_azimuth","lamp_azimuth","sun_azimuth","solar_azimuth","solar_azimuth_angle","sun_azimuth_angle","saa","azimuth_i","azimuth_in"],theta_r:["theta_r","theta_o","theta_out","theta_e","theta_refl","theta_reflected","theta_v","theta_view","theta_viewer","theta_viewing","theta_scatter","theta_scattered","theta_detector","theta_camera","theta_sensor","r_theta","o_theta","out_theta","reflection_angle","reflected_angle","scatter_angle","scattering_angle","exit_angle","emi","emission","emission_angle","emergence","emergence_angle","detector_angle","view_angle","viewing_angle","view_zenith","viewing_zenith","view_theta","view_zenith_angle","viewing_zenith_angle","vza","sensor_zenith","detector_zenith","camera_zenith","reflected_zenith","scatter_zenith","outgoing_theta","outgoing_zenith","zenith_r","zenith_o","zenith_out","polar_r","polar_o","polar_out"],phi_r:["phi_r","phi_o","phi_out","phi_e","phi_refl","phi_reflected","phi_v","phi_view","phi_viewer","phi_viewing","phi_scatter","phi_scattered","phi_detector","phi_camera","phi_sensor","phi_s","r_phi","o_phi","out_phi","reflected_azimuth","scatter_azimuth","view_azimuth","viewing_azimuth","view_phi","view_azimuth_angle","viewing_azimuth_angle","vaa","sensor_azimuth","detector_azimuth","camera_azimuth","outgoing_phi","outgoing_azimuth","azimuth_r","azimuth_o","azimuth_out","phi","azimuth","dphi","delta_phi","phi_diff","relative_azimuth","relative_azimuth_angle","azimuth_difference","raa"],theta_s:["theta_s"],theta_h:["theta_h","theta_half"],theta_d:["theta_d","theta_diff","theta_difference"],phi_d:["phi_d","phi_difference"],phi_h:["phi_h","phi_half"]},vectors:{wi_x:["wi_x","light_x","l_x"],wi_y:["wi_y","light_y","l_y"],wi_z:["wi_z","light_z","l_z"],wo_x:["wo_x","wr_x","view_x","v_x"],wo_y:["wo_y","wr_y","view_y","v_y"],wo_z:["wo_z","wr_z","view_z","v_z"]},times:{"":["time","elapsed","elapsed_time","age","timestamp","datetime","date"],"with unit":["t"],s:["seconds","second","secs","sec"],min:["minutes","minute","mins"],h:["hours","hour","hrs","hr"],d:["days","day"],week:["weeks","week"],a:["years","year"]},others:{scan:["scan","scan_number","scan_no","scan_index","frame"],weight:["weight","weights","solid_angle"],wavelength:["wavelength","wavelengths","lambda","wl","wvl","wave"],channel:["channel","band","color","colour","filter","primary"]},values:{brdf:["brdf","f_r","f","bsdf","brdf_value","bsdf_value","value","brdf_mean","mean_brdf","mean"],brdf_cos_r:["brdf_cos_r","brdf_cos_theta_r","f_r_cos_theta_r","f_cos_theta_r","ccbrdf","ccbsdf","cosine_corrected_brdf","cosine_corrected_bsdf"],brdf_cos_i:["brdf_cos_i","brdf_cos_theta_i","f_r_cos_theta_i","f_cos_theta_i"],reflectance_factor:["reflectance_factor","brf","hcrf","hdrf","brrf","bidirectional_reflectance_factor","radiance_factor","radiance_coefficient"]},channels:{R:["r","red"],G:["g","green"],B:["b","blue"],grey:["grey","gray","mono","white","luminance","lum","photopic"],NIR:["nir","ir","near_infrared","infrared"],SWIR:["swir"],VIS:["vis","visible"],UV:["uv"],cyan:["cyan"],magenta:["magenta"],yellow:["yellow"]},uncertainty:{signs:["±","+/-","+-"],words:["unc","uncert","uncertainty","uncertainties","sigma","std","stdev","stddev","sd","err","error","stderr","se","standarddeviation"],first:["u","delta"],relative:["rel","relative"],expanded:["expanded","k2","u95","ci95"],passed_over:["of","in","the","abs","absolute","standard","total","combined"]},index:["index","id","row","row_id","row_number","rownames","row_names","no","nr","number","point","point_id","n","k"],remarks:["comment","comments","remark","remarks","note","notes","file","filename","file_name","operator"],units:{angle:{deg:["deg","degs","degree","degrees","°"],rad:["rad","rads","radian","radians"],mrad:["mrad"]},time:{s:["s","sec","secs","second","seconds"],min:["min","mins","minute","minutes"],h:["h","hr","hrs","hour","hours"],d:["d","day","days"],week:["week","weeks","wk"],a:["a","y","yr","yrs","year","years"]},length:{nm:["nm","nanometer","nanometers","nanometre","nanometres"],um:["um","μm","micron","microns","micrometer","micrometers","micrometre","micrometres"],mm:["mm"],m:["m","metre","metres","meter","meters"],angstrom:["å","angstrom","angstroms"]},brdf:{"1/sr":["1/sr","/sr","sr^-1","sr-1","sr**-1","per sr","per steradian","sr^(-1)","sr^{-1}","inverse steradian","sr_1","inv_sr"]},ratio:{"%":["%","percent","pct"],"1":["1","-","dimensionless","fraction"]}},factors:{deg:.017453292519943295,rad:1,mrad:.001,s:.0002777777777777778,min:.016666666666666666,h:1,d:24,week:168,a:8766,nm:1,um:1e3,mm:1e6,m:1e9,angstrom:.1,"1/sr":1,"%":.01,"1":1},missing:["","nan","na","n/a","#n/a","#na","null","none","-","--","nd","n.d.","missing","#value!","#div/0!"]};var Qs=Zt.factors,vd=new Set(Zt.missing),N0={angle:"angle",time:"time",wavelength:"length",value:"brdf",uncertainty:"brdf"},D0={θ:"theta",ϑ:"theta",φ:"phi",ϕ:"phi",λ:"lambda",σ:"sigma",δ:"delta_"},F0=/^(?:x|wl|w|wavelength|lambda|l)?[ _]*((?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d{1,2})?)[ _]*([a-zµμå]*)$/,_d=/^(?:(.*?)\s*\[\s*(.+?)\s*\]|(.*?):\s*(.+?))$/,vi=Zt.uncertainty,yd=Zt.channels;function Mn(i){let t=i.normalize("NFKC").replaceAll("−","-").replaceAll("µ","μ").trim().toLowerCase().replace(/[θϑφϕλσδ]/g,n=>D0[n]);return vi.signs.reduce((n,r)=>n.replaceAll(r," uncertainty "),t).trim()}var dn=i=>i.replace(/[^a-z0-9]/g,""),Rr=new Map,Aa=new Map;for(let[i,e]of[[Zt.angles,"angle"],[Zt.vectors,"vector"],[Zt.values,"value"],[yd,"value"]])for(let[t,n]of Object.entries(i))for(let r of n)Rr.set(dn(r),{role:e,name:t,unit:""});for(let[i,e]of Object.entries(Zt.times))for(let t of e)Rr.set(dn(t),{role:"time",name:"",unit:i});for(let[i,e]of Object.entries(Zt.others))for(let t of e)Rr.set(dn(t),{role:i,name:"",unit:""});for(let i of Zt.index)Rr.set(dn(i),{role:"index",name:"",unit:""});for(let i of Zt.remarks)Rr.set(dn(i),{role:"remark",name:"",unit:""});for(let[i,e]of Object.entries(Zt.values))for(let t of e)Aa.set(dn(t),i);var ts=new Map;for(let[i,e]of Object.entries(Zt.units))for(let[t,n]of Object.entries(e))for(let r of n)ts.set(r,[...ts.get(r)??[],[i,t]]);function cr(i,e){let t=ts.get(Mn(i))?.find(([n])=>n===e||e==="brdf"&&n==="ratio");return t?t[1]:null}var dh=i=>ts.has(Mn(i)),ph=i=>N0[i]??null,lr=(i,e={})=>({role:i,name:"",unit:"",channel:"",wavelength:null,unitOfWavelength:"",relative:!1,expanded:!1,...e});function eo(i){let e=null;for(let[t,n]of U0(Mn(i))){let r=O0(t,i);if(!r||r.role==="index"||r.role==="remark"){if(n===""&&r)return r;continue}if(n==="")return r.unit==="with unit"?null:r;let s=ph(r.role),o=s?cr(n,s):null;if(o!==null&&(r.unit===""||r.unit==="with unit"))return o==="%"&&r.role==="uncertainty"?{...r,unit:"%",relative:!0}:{...r,unit:o};o===null&&n.length>1&&(e??=r)}if(e)throw new oe(`The column '${i}' is ${e.role} ${e.name} by its name, and its unit is that of something else`,"Correct the name");return null}function U0(i){let e=[];for(let t of[/^(.+?)\s*\(([^()]*(?:\(-?1\))?)\)$/,/^(.+?)\s*\[([^[\]]*)\]$/,/^(.+?)\s*\{([^{}]*)\}$/]){let n=t.exec(i);n&&ts.has(n[2].trim())&&e.push([n[1],n[2].trim()])}for(let t of[/^(.+?)\s+in\s+(.+)$/,/^(.+?)\s*\/\s*(.+)$/,/^(.+)[\s_.,]+(\S+)$/,/^(.+?)(%|°)$/]){let n=t.exec(i),r=n?.[2].replace(/^[ .]+|[ .]+$/g,"");n&&ts.has(r)&&!["1","-"].includes(n[2])&&e.push([n[1],r])}return[...e,[i,""]]}function O0(i,e){let t=Rr.get(dn(i));return t?t.role==="value"&&!(t.name in Zt.values)?lr("value",{name:"brdf",channel:t.name}):lr(t.role,{name:t.name,unit:t.unit}):B0(i,e)??Ta(i,e)}function Ta(i,e){let t=/^(?:channel|band|ch)[ _]*(\d+)$/.exec(i);if(t)return lr("value",{name:"brdf",channel:`channel ${t[1]}`});let n=xd(i);if(n)return n;let r=_d.exec(i),s=r?Aa.get(dn(r[1]??r[3]??"")):void 0;if(r&&s){let a=Md(r[2]??r[4],e),l=Ta(Mn(a),a);return l?.wavelength!=null?{...l,name:s}:lr("value",{name:s,channel:a})}let o=i.split(/[^a-z0-9.]+/).filter(Boolean);for(let a=1;a<o.length;a+=1)for(let[l,c]of[[o.slice(0,a),o.slice(a)],[o.slice(-a),o.slice(0,-a)]]){let h=Aa.get(l.join("")),u=h?bd(c.join(" ")):null;if(h&&u)return{...u,name:h}}return null}function xd(i){let e=F0.exec(i),t=e?e[2]?cr(e[2],"length"):"":null;return e&&t!==null?lr("value",{name:"brdf",channel:i,wavelength:Number(e[1]),unitOfWavelength:t}):null}function bd(i){let e=Rr.get(dn(i));return e?e.name in yd?lr("value",{name:"brdf",channel:e.name}):null:xd(i)}function Md(i,e){let t=Mn(e).indexOf(i);return t>=0&&Mn(e).length===e.trim().length?e.trim().slice(t,t+i.length):i}function B0(i,e){let t=_d.exec(i);if(t?.[2]&&[...vi.words,...vi.first].includes(dn(t[1]))){let h=Ta(`brdf[${t[2]}]`,`brdf[${Md(t[2],e)}]`);return h?{...h,role:"uncertainty",name:""}:null}let n=i.replace(/\b(standard|std)[ _.]*(deviation|dev)\b/g,"stddev").split(/[^a-z0-9.]+/).filter(Boolean),r=/k\s*=\s*2\b/.test(i),s=n.some(h=>vi.relative.includes(h)),o=r||n.some(h=>vi.expanded.includes(h)),a=n.filter(h=>!vi.relative.includes(h)&&!vi.expanded.includes(h)&&!(r&&(h==="k"||h==="2"))),l=new Set(a.map((h,u)=>vi.words.includes(h)||u===0&&vi.first.includes(h)?u:-1).filter(h=>h>=0));if(!l.size&&!(o&&!a.length)||a[0]==="u"&&l.has(0)&&e.trim().startsWith("U")&&!o)return null;if(a=a.filter((h,u)=>!l.has(u)&&!vi.passed_over.includes(h)),!a.length||Aa.has(a.join("")))return lr("uncertainty",{relative:s,expanded:o});let c=bd(a.join(" "))??Ta(a.join(" "),a.join(" "));return c?lr("uncertainty",{relative:s,expanded:o,channel:c.channel,wavelength:c.wavelength,unitOfWavelength:c.unitOfWavelength}):null}function Sd(i){let e=s=>new Set(Array.from({length:Math.max(s.length-1,1)},(o,a)=>s.slice(a,a+2))),t=e(dn(Mn(i))),n=s=>{let o=e(dn(s));return 2*[...o].filter(a=>t.has(a)).length/(o.size+t.size)},r=[Zt.angles,Zt.vectors,Zt.times,Zt.others,Zt.values,Zt.channels].flatMap(s=>Object.values(s).flat());return[...new Set(r.filter(s=>s.length>1))].sort((s,o)=>n(o)-n(s)).slice(0,3)}var gh=/^\s*(?:#|%|\/\/|!)/,k0=400,vh="blanks",_h="two blanks or more",z0=["	",";",",","|",_h,vh],Ea=/^[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?$/,H0=/^([-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?)\s*([^\d\s.,+-].*)$/,G0="A header names the columns, such as theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,brdf";function wd(i){let e=new Uint8Array(i),[t,n]=[e[0],e[1]];if(t===255&&n===254)return new TextDecoder("utf-16le").decode(i);if(t===254&&n===255)return new TextDecoder("utf-16be").decode(i);let r=e.slice(0,2e3);for(let[s,o]of[[1,"utf-16le"],[0,"utf-16be"]]){let a=r.filter((l,c)=>l===0&&c%2===s).length;if(e.length>=8&&a>.4*r.length)return new TextDecoder(o).decode(i)}try{return new TextDecoder("utf-8",{fatal:!0}).decode(i)}catch{return new TextDecoder("windows-1252").decode(i)}}function V0(i){try{let e=eo(i);return e?e.role==="angle"||e.role==="vector"?"direction":e.role:""}catch{return"direction"}}function W0(i){let e=i.filter(t=>t&&t.length<=100).map(V0).filter(Boolean);return e.includes("direction")&&e.length>=2?e.length:0}function Ad(i,e,t=!1){if(e===_h)return i.trim().split(/\s{2,}|\t/).map(mh);if(e===vh){if(!t)return i.trim().split(/\s+/).map(mh);let o=[];for(let a of i.match(/"[^"]*"|[([{][^)\]}]*[)\]}]|[^\s([{"]+(?:[([{][^)\]}]*[)\]}])?/g)??[])o.length&&"([{".includes(a[0])?o[o.length-1]+=` ${a}`:o.push(mh(a));return o}if(!i.includes('"'))return i.split(e).map(o=>o.trim());let n=[],r="",s=!1;for(let o=0;o<i.length;o+=1){let a=i[o];a==='"'&&s&&i[o+1]==='"'?(r+='"',o+=1):a==='"'?s=!s:a===e&&!s?(n.push(r.trim()),r=""):r+=a}return[...n,r.trim()]}var mh=i=>i.trim().replace(/^"|"$/g,"");function $0(i,e,t){let n=Td(i.slice(0,e+50),e+1,t).next();return n.done?null:n.value[1]}function*Td(i,e,t){let n=t===_h?vh:t;for(let r=e;r<i.length;r+=1){let s=i[r];if(!s||gh.test(s))continue;let o=/#(?:N\/A|NA|VALUE|DIV)/i.test(s)?s:s.split("#")[0];if(!o.trim())continue;let a=Ad(o,n);a.some(Boolean)&&(yield[r+1,a])}}function X0(i){let e=null,t=null;for(let n=0;n<Math.min(i.length,k0);n+=1){let r=i[n];if(!r.trim())continue;let s=gh.test(r),o=s?r.trim().replace(/^[#%!/]+/,"").trim():r.split("#")[0].trimEnd(),a=null;for(let h of z0){let u=Ad(o,h,!0),f=W0(u);f>(a?.[0]??0)&&(a=[f,{at:n,separator:h,cells:u,commented:s}])}if(!a)continue;let l=$0(i,n,a[1].separator),c=l!==null&&a[1].cells.filter(Boolean).length<=l.length&&l.length<=a[1].cells.length+1;if(c&&!s)return a[1];c?e=a[1]:s||(t??=a[1])}return e??t}function Ed(i,e){let t=e.replace(/^\ufeff/,"").split(/\r\n|\r|\n/),n=X0(t);if(!n)throw new oe(`${i} has no line that names columns of directions; its first line is ${Bt(t.find(a=>a.trim())?.trim()??"")}`,G0);let r=[],s=t.slice(0,n.at).filter(a=>a.trim()&&!gh.test(a)&&!/^\s*sep=.\s*$/i.test(a));s.length&&r.push(`${s.length} line${s.length>1?"s":""} before the header passed over, from '${s[0].trim().slice(0,40)}' on`),n.commented&&r.push("The header stands in a comment, the last before the numbers");let o=[...Td(t,n.at+1,n.separator)];return q0(i,{header:n.cells,rows:o.map(([,a])=>a),lines:o.map(([a])=>a),notes:r,units:[]})}function q0(i,e){let{header:t,rows:n,lines:r}=e,{notes:s}=e;for(;t.length&&t.at(-1)===""&&n.every(u=>u.length<t.length||u[t.length-1]==="");)t=t.slice(0,-1);n=n.map(u=>{let f=u.length;for(;f>t.length&&u[f-1]==="";)f-=1;return u.slice(0,f)}),n.length&&n.every(u=>u.length===t.length+1)&&Y0(n.map(u=>u[0]))&&(t=["",...t]);let o=n.map(u=>u.length===t.length&&u.every((f,p)=>f===t[p])),a=o.filter(Boolean).length;a&&(s.push(`The header stands ${a} more time${a>1?"s":""} further down, passed over`),n=n.filter((u,f)=>!o[f]),r=r.filter((u,f)=>!o[f]));let l=[],c=u=>u.replace(/^[()[\] ]+|[()[\] ]+$/g,""),h=n[0];return h&&h.length<=t.length&&h.some(Boolean)&&h.every(u=>u===""||dh(c(u)))&&!h.some(u=>Ea.test(u))&&(l=t.map((u,f)=>c(h[f]??"")),n=n.slice(1),r=r.slice(1),s.push("The row below the header holds units")),n.forEach((u,f)=>{if(u.length!==t.length)throw new oe(`${i}, line ${r[f]} has ${u.length} cells; the header has ${t.length}`,"Each row has a cell for each column, empty where nothing was measured")}),{header:t,rows:n,lines:r,notes:s,units:l}}function Y0(i){return i.every(e=>/^\d{1,9}$/.test(e))?(i[0]==="0"||i[0]==="1")&&i.every((e,t)=>Number(e)-Number(i[0])===t):!i.some(e=>Ea.test(e))}var to=class{constructor(e,t,n){this.name=e;this.table=t;let r=null,s=null;t.rows.forEach((l,c)=>{for(let h of n){let u=l[h];u.includes(",")?r??=[t.lines[c],u]:u.includes(".")&&(s??=[t.lines[c],u])}});let[o,a]=[r,s];if(o&&a&&/\d\.\d|^\./.test(a[1])&&/\d,\d/.test(o[1]))throw new oe(`${e} has numbers with decimal commas ('${o[1].slice(0,20)}', line ${o[0]}) and with decimal points ('${a[1].slice(0,20)}', line ${a[0]})`,"Write all of them in one way");this.decimalComma=o!==null}name;table;decimalComma;column(e){let t="";return{values:this.table.rows.map((r,s)=>{let o=this.decimalComma?r[e].replaceAll(",","."):r[e];if(vd.has(o.toLowerCase()))return NaN;let a=o.replaceAll("−","-").replace(/[\u00a0\u202f]/g,""),l=Ea.test(a)?null:H0.exec(a);if(l&&dh(l[2])){if(a=l[1],t&&Mn(l[2])!==Mn(t))throw this.error(s,e,`'${l[2].trim()}' stands where '${t}' stands above`);t||=l[2].trim()}let h=/^[-+]?inf(inity)?$/i.test(a)?a.startsWith("-")?-1/0:1/0:Ea.test(a)?Number(a.replace(/[dD]/,"e")):NaN;if(Number.isNaN(h))throw this.error(s,e,`'${o.slice(0,40)}' is not a number`);return h}),unit:t}}error(e,t,n){return new oe(`${this.name}, line ${this.table.lines[e]}: ${n} (column ${this.table.header[t]||t+1})`,"Leave a cell empty where nothing was measured")}};var xh=1e-6,Z0=2*Math.PI+1e-6,Ld=100,yh="phase",Rd=.06*Math.PI/180,Cd=["theta_i","phi_i","theta_r","phi_r"],no=["theta_h","theta_d","phi_d","phi_h"],io=["wi_x","wi_y","wi_z","wo_x","wo_y","wo_z"],ro="Rename the column, or give motes info the option --read column:NAME=ROLE";function Nd(i,e){let t=Ed(i,e),n=K0(i,t);if(!t.rows.length)throw new oe(`${i} has a header and no row below it`,"It needs a row a sample");let r=[...n.angles.values(),...n.values,...n.uncertainties];for(let p of["weight","wavelength"])n.single.has(p)&&r.push(n.single.get(p));let s=new to(i,t,r);s.decimalComma&&t.notes.push("Its numbers have decimal commas");let o=nv(i,t,n,s),a=sv(i,t,n),{values:l,factors:c}=av(i,t,n,s,o),h=lv(i,t,n,s,l,c),u=o.map(([p,v],y)=>({hours:a[y],wi:p,wo:v,values:l[y],uncertainties:h?.[y]??null})),f=n.single.has("scan")?"scan":"h";for(let p of["wavelength","channel"])if(n.single.has(p))return{...cv(i,t,n,s,u,p),unit:f,notes:t.notes};return{...Fd(i,n.values.map(p=>n.columns[p])),unit:f,samples:u,notes:t.notes}}var En=(i,e)=>i[e]?`'${i[e].slice(0,60)}'`:String(e+1);function K0(i,e){let{header:t,notes:n}=e,r={columns:[],angles:new Map,values:[],uncertainties:[],of:[],single:new Map,degrees:[],bare:[]};return t.forEach((s,o)=>{let a=Dd(i,s);if(!a&&Id(e,o)){n.push(`The column ${En(t,o)} numbers or names the rows and is left out`),r.columns.push(null);return}if(!a||a.role==="index"&&!Id(e,o))throw J0(i,t,o);if(a.role==="index"||a.role==="remark"){n.push(`The column ${En(t,o)} ${a.role==="index"?"numbers the rows":"holds remarks"} and is left out`),r.columns.push(null);return}let l=j0(i,e,a,o);r.columns.push(l),l.role==="angle"||l.role==="vector"?Pd(i,t,r.angles,l.name,o):l.role==="value"?r.values.push(o):l.role==="uncertainty"?r.uncertainties.push(o):Pd(i,t,r.single,l.role,o)}),Q0(i,e,r),ev(i,e,r),r}function Dd(i,e){if(e==="")return null;try{return eo(e)}catch(t){throw t instanceof oe?new oe(`${i}: t${t.message.slice(1)}`,ro):t}}function Id(i,e){let t=Mn(i.header[e]),n=t===""||/^unnamed:? ?\d+(\.\d+)*$/.test(t);if(!n&&eo(t)?.role!=="index")return!1;let r=i.rows.map(o=>o[e]);if(r.every(o=>o===""))return!0;let s=r.map(o=>o===""?NaN:Number(o));return s.some(Number.isNaN)?n&&new Set(r).size===r.length&&s.every(Number.isNaN):s.length<2||s.every((o,a)=>a===0||o-s[a-1]===1)||!n&&s.every(Number.isInteger)}function J0(i,e,t){return e[t]?new oe(`${i}: the column ${En(e,t)} is not known; the nearest names are ${Sd(e[t]).join(", ")}`,ro):new oe(`${i}: column ${t+1} has no name and does not number the rows`,ro)}function j0(i,e,t,n){let r=e.units[n]??"";t.role==="value"&&(t.unit==="%"||t.unit==="1")&&(r||=t.unit);let s=ph(t.role);if(!r||!s)return t;let o=cr(r,s),a=t.unit==="with unit"?"":t.unit,l=e.header[n];if(o===null||a&&a!==o)throw new oe(`${i}: the column '${l}' has the unit '${r}'${a?`, and its name says ${a}`:`, which is no unit of ${t.name||t.role}`}`,"Correct one of them");if(t.role==="value"&&t.name!=="reflectance_factor"&&(o==="%"||o==="1"))throw new oe(`${i}: the column '${l}' has the unit '${r}', and a BRDF is in 1/sr`,"Where it is pi times the BRDF, call it reflectance_factor");return{...t,unit:o,relative:t.relative||t.role==="uncertainty"&&o==="%"}}function Pd(i,e,t,n,r){if(t.has(n))throw new oe(`${i}: the columns ${En(e,t.get(n))} and ${En(e,r)} are both ${n}`,"Leave one out");t.set(n,r)}function Q0(i,e,t){let n=t.angles.get("theta_s");if(n===void 0)return;if(t.angles.delete("theta_s"),t.angles.has("theta_i")===t.angles.has("theta_r"))throw new oe(`${i}: the column ${En(e.header,n)} may be the angle of the scattered light or of the sun`,ro);let r=t.angles.has("theta_i")?"theta_r":"theta_i";t.angles.set(r,n),e.notes.push(`The column ${En(e.header,n)} is taken for ${r}, the other one being there`);let s=t.angles.get("phi_r");r==="theta_i"&&s!==void 0&&dn(Mn(e.header[s])).startsWith("phis")&&(t.angles.delete("phi_r"),t.angles.set("phi_i",s))}function ev(i,e,t){let{header:n}=e,r=["wavelength","channel"].filter(o=>t.single.has(o));if(r.length===2)throw new oe(`${i}: two columns name the channel of a row`,"Leave one out");if(t.single.has("time")&&t.single.has("scan")&&t.single.delete("scan"),!t.values.length)throw new oe(`${i} has no column of values; its columns are ${n.slice(0,12).join(", ")}`,"Name a column of the BRDF [1/sr] brdf, or R, G, B, or by its wavelength (630 nm)");if(r.length&&t.values.length>1)throw new oe(`${i} has a row for each ${r[0]} and yet ${t.values.length} columns of values`,"Leave all but one out");let s=new Map;for(let o of t.values){let a=t.columns[o],l=a.wavelength===null?a.channel:`${a.wavelength} ${a.unitOfWavelength}`;if(s.has(l))throw new oe(`${i}: the columns ${En(n,s.get(l))} and ${En(n,o)} hold values of the same channel`,"Leave one out");s.set(l,o)}for(let o of t.uncertainties){let a=tv(i,e,t,o);if(t.of.includes(a)||t.of.length&&(a===-1||t.of.includes(-1)))throw new oe(`${i}: the columns ${En(n,t.uncertainties[Math.max(t.of.indexOf(a),0)])} and ${En(n,o)} are both uncertainties of the same values`,"Leave one out");t.of.push(a)}}function tv(i,e,t,n){let r=t.columns[n];if(r.channel===""&&r.wavelength===null){if(t.values.length>1&&!r.relative)throw new oe(`${i}: the column ${En(e.header,n)} is an uncertainty [1/sr] of one of ${t.values.length} channels, and does not say of which`,"Call it uncertainty[R], for example");return t.values.length===1?0:-1}let s=t.values.map((o,a)=>a).filter(o=>{let a=t.columns[t.values[o]];return r.wavelength===null?dn(Mn(a.channel))===dn(Mn(r.channel)):a.wavelength===r.wavelength&&["",a.unitOfWavelength].includes(r.unitOfWavelength)});if(s.length!==1)throw new oe(`${i}: the column ${En(e.header,n)} is the uncertainty of ${r.channel}, and no column of values is called so`,ro);return s[0]}function nv(i,e,t,n){let r=y=>t.angles.has(y),s=[io,no,[...Cd,yh]].filter(y=>y.some(r)),o=r(yh);if(s.length!==1||o&&r("phi_r"))throw new oe(`${i} gives directions in several ways: ${[...t.angles.keys()].join(", ")}`,"Leave one way out");let l=(s[0]===io?io:s[0]===no?no.slice(0,3):o?["theta_i","theta_r"]:["theta_i","theta_r","phi_r"]).filter(y=>!r(y));if(l.length)throw new oe(`${i} has no column ${l.join(", ")}; it has ${e.header.slice(0,12).join(", ")}`,"Add them");let c=y=>{let m=t.angles.get(y),g=n.column(m),A=g.values.findIndex(M=>!Number.isFinite(M));if(A>=0)throw new oe(`${i}, line ${e.lines[A]}: ${e.header[m]} is missing or not finite`,"Fill it in");return g},h=y=>r(y)?iv(i,e,t,y,c(y)):e.rows.map(()=>0);if(s[0]===io){let y=io.map(m=>c(m).values);return e.rows.map((m,g)=>[0,3].map(M=>[0,1,2].map(w=>y[M+w][g])).map((M,w)=>{let T=Math.hypot(...M);if(!(Math.abs(T-1)<=.001))throw new oe(`${i}: ${w?"wo":"wi"} in row ${g} has the length ${T.toPrecision(6)} instead of 1`,"Directions are unit vectors");return M.map(E=>E/T)}))}if(s[0]===no){let[y,m,g,A]=no.map(h);return e.rows.map((M,w)=>rv(y[w],m[w],g[w],A[w]))}let[u,f,p,v]=Cd.map(h);return o&&(h(yh).forEach((m,g)=>{let[A,M]=[u[g],p[g]];if(m<Math.abs(A-M)-Rd||m>A+M+Rd||A<0||M<0)throw new oe(`${i}, line ${e.lines[g]}: a phase angle of ${(m*180/Math.PI).toPrecision(6)} degrees is outside what the two polar angles allow`,"Check the row; polar angles beside a phase angle are not signed");let w=Math.sin(A)*Math.sin(M);v[g]=f[g]+(w>1e-12?Math.acos(Math.min(1,Math.max(-1,(Math.cos(m)-Math.cos(A)*Math.cos(M))/w))):0)}),e.notes.push("The azimuth between light and viewer follows from the phase angle")),r("phi_i")||e.notes.push("phi_i is missing and taken as 0"),[...u,...p].some(y=>y<0)&&e.notes.push("Negative polar angles are taken for the opposite azimuth"),e.rows.map((y,m)=>[Ra(u[m],f[m]),Ra(p[m],v[m])])}function iv(i,e,t,n,r){let s=t.angles.get(n),o=e.header[s],a=t.columns[s].unit,l=r.unit?cr(r.unit,"angle"):"";if(l===null||l&&a&&l!==a)throw new oe(`${i}: the cells of '${o}' are in '${r.unit}'${a?`, its name says ${a}`:""}`,"Correct one of them");let c=a||l;if(c==="deg"?t.degrees.push(o):c||t.bare.push(o),t.bare.length&&(t.degrees.length||t.columns.some(f=>f?.role==="angle"&&f.unit==="deg")))throw new oe(`${i}: '${t.bare[0]}' names no unit, and other angles are in degrees`,`Call it ${t.bare[0]}_deg or ${t.bare[0]}_rad`);let h=r.values.map(f=>f*Qs[c||"rad"]),u=h.findIndex(f=>Math.abs(f)>Z0);if(u>=0)throw new oe(`${i}, line ${e.lines[u]}: ${o} = ${r.values[u]} is outside +-2 pi rad (+-360 degrees)`,c?"Check the row":`Angles are in radians; call it ${o}_deg for degrees`);return h}var Ra=(i,e)=>[Math.sin(i)*Math.cos(e),Math.sin(i)*Math.sin(e),Math.cos(i)];function rv(i,e,t,n){let[r,s,o]=Ra(e,t),[a,l]=[Math.cos(i),Math.sin(i)],[c,h,u]=[a*r+l*o,s,a*o-l*r],[f,p]=[Math.cos(n),Math.sin(n)],v=[f*c-p*h,p*c+f*h,u],y=Ra(i,n),m=2*(v[0]*y[0]+v[1]*y[1]+v[2]*y[2]);return[v,[m*y[0]-v[0],m*y[1]-v[1],m*y[2]-v[2]]]}function sv(i,e,t){let n=["time","scan"].find(u=>t.single.has(u));if(!n)return e.rows.map(()=>0);let r=t.single.get(n),s=e.rows.map(u=>u[r].trim());if(n==="time"&&/\d[:/-]\d|\d\.\d+\.\d/.test(s.find(Boolean)??""))return ov(i,e,r,s);let{values:o,unit:a}=new to(i,e,[r]).column(r),l=o.findIndex(u=>!Number.isFinite(u));if(l>=0)throw new oe(`${i}, line ${e.lines[l]}: ${e.header[r]} is missing or not finite`,"Fill it in");if(n==="scan")return o;let c=t.columns[r].unit,h=a?cr(a,"time"):"";if(h===null||h&&c&&h!==c)throw new oe(`${i}: the cells of '${e.header[r]}' are in '${a}'`,"Correct one of them");return o.map(u=>u*Qs[c||h||"h"])}function ov(i,e,t,n){let r=n.map(a=>/^(-?)(\d{1,6}):(\d{2})(?::(\d{2}(?:\.\d+)?))?$/.exec(a));if(r.every(Boolean))return r.map(a=>(a[1]?-1:1)*(Number(a[2])+Number(a[3])/60+Number(a[4]??0)/3600));let s=n.map((a,l)=>{let c=/^(\d{4})-(\d{2})-(\d{2})(?:[T ](\d{2}):(\d{2})(?::(\d{2}(?:\.\d+)?))?)?(Z|[+-]\d{2}:\d{2})?$/.exec(a);if(!c)throw new oe(`${i}, line ${e.lines[l]}: '${a.slice(0,40)}' is no time`,`Write dates in ${En(e.header,t)} as 2024-05-01 10:30, durations as 1:30:00, or numbers of hours`);let h=!c[7]||c[7]==="Z"?0:(c[7][0]==="-"?-1:1)*(Number(c[7].slice(1,3))+Number(c[7].slice(4))/60);return Date.UTC(Number(c[1]),Number(c[2])-1,Number(c[3]))/36e5+Number(c[4]??0)+Number(c[5]??0)/60+Number(c[6]??0)/3600-h}),o=Math.min(...s);return s.map(a=>a-o)}function av(i,e,t,n,r){let s=t.values.map(c=>n.column(c));s.forEach(({unit:c},h)=>{if(c&&cr(c,"brdf")!=="1/sr")throw new oe(`${i}: the cells of '${e.header[t.values[h]]}' are in '${c}', and a BRDF is in 1/sr`,"Write the unit in the header")});let o=t.values.map(c=>t.columns[c]);o.some(c=>c.name==="reflectance_factor")&&e.notes.push("f_r = reflectance factor / pi"),o.some(c=>c.name==="brdf_cos_r")&&e.notes.push("f_r = cosine-corrected BRDF / cos(theta_r)"),o.some(c=>c.name==="brdf_cos_i")&&e.notes.push("f_r = BRDF times cos(theta_i) / cos(theta_i)");let a=c=>c>0?1/c:NaN,l=r.map(([c,h])=>o.map(u=>u.name==="reflectance_factor"?Qs[u.unit||"1"]/Math.PI:u.name==="brdf_cos_r"?a(h[2]):u.name==="brdf_cos_i"?a(c[2]):1));return{values:l.map((c,h)=>c.map((u,f)=>s[f].values[h]*u)),factors:l}}function lv(i,e,t,n,r,s){if(!t.uncertainties.length)return null;let o=r.map(a=>a.map(()=>NaN));return t.uncertainties.forEach((a,l)=>{let c=t.columns[a],{values:h,unit:u}=n.column(a),f=c.unit==="%"||u==="%"?.01:1,p=t.of[l]<0?t.values.map((y,m)=>m):[t.of[l]],v=h.filter((y,m)=>p.some(g=>Number.isFinite(r[m][g]))&&!(y>0&&Number.isFinite(y)));if(v.length)throw new oe(`${i}: the uncertainty ${e.header[a]}: ${v.length} of ${h.length} are not above 0`,"An uncertainty is one standard deviation");h.forEach((y,m)=>{for(let g of p){let M=y*f/(c.expanded?2:1)*Math.abs(c.relative||u==="%"?r[m][g]:s[m][g]);M>0&&(o[m][g]=M)}})}),o}function Fd(i,e){if(e.every(t=>t.wavelength!==null)){let t=new Set(e.map(r=>r.unitOfWavelength));if(t.size===2&&t.has("")&&t.has("nm")&&t.delete(""),t.size>1)throw new oe(`${i}: the wavelengths are in ${[...t].map(r=>r||"no unit").sort().join(", ")}`,"Write all in one unit");let n=Od(i,e.map(r=>r.wavelength),[...t][0]);return{channels:n.map(Ud),wavelengths:n}}return{channels:e.map(t=>t.channel||(e.length===1?"grey":t.name)),wavelengths:null}}var Ud=i=>`${Number(i.toPrecision(6))} nm`;function Od(i,e,t){let n=e.reduce((r,s)=>Math.min(r,s));if(!t&&n<Ld)throw new oe(`${i}: the wavelengths, from ${n} to ${e.reduce((r,s)=>Math.max(r,s))}, name no unit and are no light in nm`,"Write their unit, as in 0.63 um");return e.map(r=>Number((r*Qs[t||"nm"]).toFixed(6)))}function cv(i,e,t,n,r,s){let o=t.single.get(s),a,l=null,c;if(s==="wavelength"){let{values:y,unit:m}=n.column(o),g=y.findIndex(w=>!(w>0&&Number.isFinite(w)));if(g>=0)throw new oe(`${i}, line ${e.lines[g]}: ${e.header[o]} is missing or not above 0`,"Fill it in");let A=Od(i,y,t.columns[o].unit||(m?cr(m,"length")??"":""));l=[...new Set(A)].sort((w,T)=>w-T),a=l.map(Ud);let M=new Map(l.map((w,T)=>[w,T]));c=A.map(w=>M.get(w))}else{let y=e.rows.map(w=>w[o]),m=y.indexOf("");if(m>=0)throw new oe(`${i}, line ${e.lines[m]}: ${e.header[o]} is missing`,"Fill it in");let g=[...new Set(y)],A=new Map(g.map((w,T)=>[w,T]));c=y.map(w=>A.get(w));let M=g.map(w=>Dd(i,/^\d+$/.test(w)&&Number(w)<Ld?`channel ${w}`:w));M.every(w=>w?.role==="value")?{channels:a,wavelengths:l}=Fd(i,M):a=g}let h=new Map;r.forEach((y,m)=>{let g=[y.hours,...y.wi,...y.wo].map(A=>(Math.round(A*1e6)+0).toString()).join(" ");h.has(g)||h.set(g,{sample:y,rows:a.map(()=>[])}),h.get(g).rows[c[m]].push(m)});let u=[],f=a.map((y,m)=>[...h.values()].reduce((g,A)=>g+A.rows[m].length,0)),p=[...h.values()].reduce((y,m)=>y+Math.max(...m.rows.map(g=>g.length)),0),v=f.findIndex(y=>y<p);if(v>=0)throw new oe(`${i}: the channel ${a[v]} has ${f[v]} of ${p} directions`,"Give each channel a row for each pair of directions, with an empty cell where nothing was measured");for(let y of h.values())y.rows[0].forEach((m,g)=>{let A=y.rows.map(M=>r[M[g]]);u.push({...y.sample,values:A.map(M=>M.values[0]),uncertainties:A[0].uncertainties&&A.map(M=>M.uncertainties[0])})});return{channels:a,wavelengths:l,samples:u}}var Bd=6e3,kd=200*2**20;function zd(i){let[e,t,n]=[i.wi,i.wo,i.values].map(r=>new Float32Array(gi(r)));return Gd(i.name,i.channels,i.hours,i.time_unit,e,t,n,i.note)}function Hd(i,e){if(e.length>kd)throw new oe(`${i} has ${Math.round(e.length/2**20)} MB, more than ${kd/2**20}`,"motes view DATA thins any measurement");let t=Nd(i,e),n=t.samples.filter(({wi:m,wo:g})=>m[2]>xh&&g[2]>xh),r=t.samples.length-n.length;if(!n.length)throw new oe(`${i} has no usable row`,"It needs a row a sample, with both directions above the horizon");let s=t.channels.length,o=t.channels.map((m,g)=>n.reduce((A,{values:M})=>M[g]>A&&M[g]<1/0?M[g]:A,0)),a=(m,g)=>Number.isFinite(m)&&m>=-o[g]?m:NaN,l=[...new Set(n.map(m=>m.hours))].sort((m,g)=>m-g),c=Math.max(n.length/Bd,1),h=Array.from({length:Math.min(n.length,Bd)},(m,g)=>n[Math.floor(g*c)]),u=h.length,f=new Float32Array(3*u),p=new Float32Array(3*u),v=new Float32Array(l.length*u*s).fill(NaN);h.forEach((m,g)=>{f.set(m.wi,3*g),p.set(m.wo,3*g),v.set(m.values.map(a),(l.indexOf(m.hours)*u+g)*s)});let y=[h.length<n.length?`${i} has ${n.length.toLocaleString("en")} samples; ${h.length.toLocaleString("en")} of them, evenly spread, are shown.`:"",r?`${r.toLocaleString("en")} rows with a direction at or below the horizon were left out.`:"",...t.notes.map(m=>`${m}.`)];return Gd(i,t.channels,l,t.unit,f,p,v,y.filter(Boolean).join(" "))}function Gd(i,e,t,n,r,s,o,a){let l=r.length/3,[c,h,u,f]=[0,0,0,0].map(()=>new Float32Array(l));for(let p=0;p<l;p+=1){let[v,y,m,g,A,M]=[r[3*p],r[3*p+1],r[3*p+2],s[3*p],s[3*p+1],s[3*p+2]];c[p]=Math.atan2(Math.hypot(v,y),m),h[p]=Math.atan2(Math.hypot(g,A),M),u[p]=Math.atan2(Math.hypot(v+g,y+A),m+M),f[p]=Math.atan2(v*A-y*g,v*g+y*A)}return{name:i,channels:e,hours:t,unit:n,count:l,wi:r,wo:s,values:o,thetaI:c,thetaR:h,thetaH:u,dphi:f,note:a}}function Ca(i,e){return i.hours.reduce((t,n,r)=>Math.abs(n-e)<Math.abs(i.hours[t]-e)?r:t,0)}function bh(i){let e=new Float64Array(90);for(let s=0;s<i.count;s+=1){if(Math.abs(Math.sin(i.dphi[s]))*Math.min(Math.sin(i.thetaI[s]),Math.sin(i.thetaR[s]))>.05)continue;let a=Math.round(i.thetaI[s]*180/Math.PI);a<=$t.incidence.high&&(e[a]+=1)}let t=.4*Math.max(...e),n=45,r=1/0;return e.forEach((s,o)=>{s>=t&&t>0&&Math.abs(o-45)<r&&([n,r]=[o,Math.abs(o-45)])}),n}var[Ia,Vd,hr]=[360,214,150],[Fi,ni]=[Ia/2,186],Pa=class{constructor(e){this.turn=e;this.handle=dt("g",{role:"slider",tabindex:0,class:"motes-incident","aria-label":"Angle of incidence in degrees","aria-valuemin":$t.incidence.low,"aria-valuemax":$t.incidence.high,"aria-valuenow":0},this.ray,this.grip),this.svg=dt("svg",{viewBox:`0 0 ${Ia} ${Vd}`,class:"motes-chart motes-polar",role:"group","aria-labelledby":this.title.id},this.title,this.body,this.handle),this.handle.addEventListener("pointerdown",t=>this.begin(t)),this.handle.addEventListener("keydown",t=>this.key(t))}turn;svg;title=dt("title",{id:Pi("polar")},"Polar plot");body=dt("g");handle;now=0;ray=dt("line",{class:"incident"});grip=dt("circle",{r:9,class:"grip"});draw(e,t,n,r,s){this.title.textContent=e,this.now=t;let o=0;for(let{radius:h}of[...n,...r])for(let u=0;u<h.length;u+=1)Number.isFinite(h[u])&&(o=Math.max(o,h[u]));let a=o>0?o:1;this.body.replaceChildren(...this.grid(a,s));for(let{theta:h,radius:u,tint:f,dashed:p}of n){let v="";for(let y=0;y<h.length;y+=1){let[m,g]=so(h[y],u[y]/a*hr);v+=`${y?"L":"M"}${m.toFixed(1)} ${g.toFixed(1)}`}this.body.append(dt("path",{d:v,class:`line ${f}${p?" dashed":""}`}))}for(let{theta:h,radius:u,tint:f}of r){let p="";for(let v=0;v<h.length;v+=1){let[y,m]=so(h[v],u[v]/a*hr);Number.isFinite(y)&&Number.isFinite(m)&&(p+=`M${y.toFixed(1)} ${m.toFixed(1)}h0`)}this.body.append(dt("path",{d:p,class:`dots ${f}`}))}let[l,c]=so(-en(t),hr);for(let[h,u]of[["x1",l],["y1",c],["x2",Fi],["y2",ni]])this.ray.setAttribute(h,u.toFixed(1));this.grip.setAttribute("cx",l.toFixed(1)),this.grip.setAttribute("cy",c.toFixed(1)),this.handle.setAttribute("aria-valuenow",ut(t)),this.handle.setAttribute("aria-valuetext",`${ut(t)} degrees from the normal`)}grid(e,t){let n=[dt("line",{x1:Fi-hr,x2:Fi+hr,y1:ni,y2:ni,class:"axis"})];for(let r of _a(0,e,3).slice(1)){let s=r/e*hr;n.push(dt("path",{d:`M${Fi-s} ${ni}A${s} ${s} 0 0 1 ${Fi+s} ${ni}`,class:"grid"}),dt("text",{x:Fi+s,y:ni+13,class:"tick","text-anchor":"middle"},t(r)))}for(let r of[-60,-30,0,30,60]){let[s,o]=so(en(r),hr+4),[a,l]=so(en(r),hr+15);n.push(dt("line",{x1:Fi,y1:ni,x2:s,y2:o,class:"grid"}),dt("text",{x:a,y:l+4,class:"tick","text-anchor":"middle"},`${Math.abs(r)}°`))}return n.push(dt("text",{x:6,y:ni+26,class:"tick"},"light"),dt("text",{x:Ia-6,y:ni+26,class:"tick","text-anchor":"end"},"mirror side")),n}begin(e){e.preventDefault(),this.handle.focus(),this.handle.setPointerCapture(e.pointerId);let t=r=>{let s=this.svg.getBoundingClientRect(),o=(r.clientX-s.left)/s.width*Ia-Fi,a=ni-(r.clientY-s.top)/s.height*Vd;this.set(pi(Math.atan2(-o,Math.max(a,0))))},n=()=>{this.handle.removeEventListener("pointermove",t),this.handle.removeEventListener("pointerup",n),this.handle.removeEventListener("pointercancel",n)};this.handle.addEventListener("pointermove",t),this.handle.addEventListener("pointerup",n),this.handle.addEventListener("pointercancel",n)}key(e){let t={ArrowLeft:1,ArrowUp:1,ArrowRight:-1,ArrowDown:-1,PageUp:10,PageDown:-10},n=e.key==="Home"?$t.incidence.low:e.key==="End"?$t.incidence.high:e.key in t?this.now+t[e.key]:null;n!==null&&(e.preventDefault(),this.set(n))}set(e){this.now=Math.round(Un(e,$t.incidence.low,$t.incidence.high)*2)/2,this.turn(this.now)}};function so(i,e){return[Fi+Math.sin(i)*e,ni-Math.cos(i)*e]}function ur(i,e){return e==="cube root"?Math.cbrt(i):i}function ns(i){return[-Math.sin(i),0,Math.cos(i)]}function _i(i,e){let t=i.length,n=(r,s)=>r.map((o,a)=>({channel:o,name:i[o]??String(o),tint:s[a]??"grey"}));if(t===1)return n([0],["grey"]);if(t===3)return n([0,1,2],["red","green","blue"]);if(t<=4)return n(i.map((r,s)=>s),["blue","green","red","grey"]);if(e.length===t){let r=s=>e.reduce((o,a,l)=>Math.abs(a-s)<Math.abs(e[o]-s)?l:o,0);return n([r(650),r(550),r(450)],["red","green","blue"])}return n([0,t>>1,t-1],["red","green","blue"])}var Mh=179,hv=3,uv=2.5;function Na(i,e,t=uv){let n=[],r=Math.sin(en(hv));for(let s=0;s<i.count;s+=1)Math.abs(pi(i.thetaI[s])-e)>t||Math.abs(Math.sin(i.dphi[s]))*Math.min(Math.sin(i.thetaR[s]),Math.max(Math.sin(i.thetaI[s]),.05))<=r&&n.push(s);return n}function Sh(i,e){return Math.cos(i.dphi[e])>0?-i.thetaR[e]:i.thetaR[e]}var La=class{element;polar;radius;scale;words=Ee("p",{class:"motes-caption"});constructor(e){this.polar=new Pa(t=>e({incidence:t})),this.radius=new Ni("Radius",[["f","f, the BRDF"],["f cos","f cos θ"]],t=>e({radius:t})),this.scale=new Ni("Scale",[["linear","linear"],["cube root","cube root"]],t=>e({scale:t})),this.element=Ee("div",{},this.polar.svg,this.words,Ee("div",{class:"motes-pair"},this.radius.element,this.scale.element))}update(e,t,n,r,s){this.radius.show(e.radius),this.scale.show(e.scale);let o=ns(-en(e.incidence)),a=Float32Array.from({length:Mh},(g,A)=>en(A+1-90)),l=Float32Array.from([...a].flatMap(ns)),c=new Float32Array(l.length);for(let g=0;g<Mh;g+=1)c.set(o,3*g);let h=g=>e.radius==="f cos"?Math.cos(g):1,u=[],f=[],p=e.compare==="one"?[e.active]:t.map((g,A)=>A);for(let g of p){let A=t[g];if(!A)continue;let M=r.evaluate(A,n[g],c,l),w=A.shader.channels;for(let{channel:E,tint:x}of _i(A.channels,A.wavelengths)){let b=a.map((P,I)=>ur(M[I*w+E]*h(P),e.scale));u.push({theta:a,radius:b,tint:x,dashed:g>0&&p.length>1})}let T=0;for(let E=1;E<Mh;E+=1)M[E*w]>M[T*w]&&(T=E);f.push(`${A.name}: largest ${ut(M[T*w])} 1/sr at ${ut(pi(a[T]))}°`)}let v=[],y=t[0];if(s&&y&&p.includes(0)){let g=Ca(s,e.hours),A=Na(s,e.incidence),M=A.map(w=>Sh(s,w));for(let{channel:w,tint:T}of _i(s.channels,y.wavelengths)){let E=A.map((x,b)=>ur(s.values[(g*s.count+x)*s.channels.length+w]*h(M[b]),e.scale));v.push({theta:M,radius:E,tint:T,dashed:!1})}}let m=`The ${e.radius==="f"?"BRDF":"BRDF times the cosine"} in the plane of incidence, light at ${ut(e.incidence)}° from the normal. ${f.join("; ")}.`;this.polar.draw(m,e.incidence,u,v,g=>ut(e.scale==="cube root"?g**3:g,2)),this.words.textContent=`Light at ${ut(e.incidence)}°. ${f.join("; ")}.${v.some(g=>g.theta.length)?" Dots: measured.":""} Drag the yellow handle, or focus it and use the arrow keys.`}};var fv=[-90,-60,-30,0,30,60,90],dv=2500,Da=class{element;curve=new Er("Measured and computed");rest=new Er("Residuals",170);words=Ee("p",{class:"motes-caption"});restWords=Ee("p",{class:"motes-caption"});incidence;relativeRms=NaN;constructor(e,t){this.incidence=new Li({label:"angle of incidence",symbol:"θ_i",unit:"°",...$t.incidence,step:1,set:n=>e({incidence:Math.min(Math.max(n,0),88)})},t),this.element=Ee("div",{},this.curve.svg,this.words,this.incidence.element,this.rest.svg,this.restWords)}update(e,t,n,r,s){this.incidence.show(e.incidence);let o=t.shader.channels,a=_i(s.channels,t.wavelengths),l=Ca(s,e.hours),c=(b,P)=>s.values[(l*s.count+b)*s.channels.length+P],h=b=>o===1?0:Math.min(b,o-1),u=Float32Array.from({length:179},(b,P)=>en(P+1-90)),f=Float32Array.from([...u].flatMap(ns)),p=new Float32Array(f.length);for(let b=0;b<u.length;b+=1)p.set(ns(-en(e.incidence)),3*b);let v=r.evaluate(t,n,p,f),y=Na(s,e.incidence),m=a.map(({channel:b})=>y.map(P=>ur(c(P,b),e.scale))),g=a.map(({channel:b})=>Array.from(u,(P,I)=>ur(v[I*o+h(b)],e.scale))),A=0,M=en(86);for(let b of m)for(let P of b)P>A&&(A=P);for(let b of g)b.forEach((P,I)=>Math.abs(u[I])<M&&P>A?A=P:0);let w=b=>ut(e.scale==="cube root"?b**3:b,2),T=`${s.name}: measured and computed BRDF in the plane of incidence at ${ut(e.incidence)}°`;this.curve.begin(T,{low:-90,high:90,ticks:fv,label:"θ_r (°), mirror side positive"},{low:0,high:A*1.06||1,label:"f (1/sr)",write:w}),a.forEach(({tint:b},P)=>{this.curve.line({x:u.map(pi),y:g[P],tint:b}),this.curve.dots(y.map(I=>pi(Sh(s,I))),m[P],b)}),this.curve.mark(-e.incidence);let E=y.length?"":` No sample lies within 2.5° of this incidence and 3° of the plane; the nearest incidence with one is ${this.nearest(s,e.incidence)}.`,x=s.hours.length>1?` Scan ${l+1} of ${s.hours.length}, at ${ut(s.hours[l])} ${s.unit}.`:"";this.words.textContent=`${y.length} measured directions near the plane of incidence (dots), the model (lines).${x}${E}`,this.residuals(t,n,r,s,l,c,h)}residuals(e,t,n,r,s,o,a){let l=e.shader.channels,c=n.evaluate(e,t,r.wi,r.wo),[h,u,f]=[0,0,0],p=_i(r.channels,e.wavelengths),v=p.map(()=>new Float32Array(r.count));for(let T=0;T<r.count;T+=1){for(let E=0;E<r.channels.length;E+=1){let x=o(T,E),b=c[T*l+a(E)]-x;Number.isFinite(b)&&(h+=b*b,u+=x*x,f+=1)}p.forEach(({channel:E},x)=>v[x][T]=c[T*l+a(E)]-o(T,E))}let y=Math.sqrt(u/Math.max(f,1))||1;this.relativeRms=Math.sqrt(h/Math.max(f,1))/y;let m=Math.max(Math.ceil(r.count/dv),1),g=Array.from({length:Math.floor(r.count/m)},(T,E)=>E*m),A=v.flatMap(T=>g.map(E=>Math.abs(T[E]))).filter(Number.isFinite).sort((T,E)=>T-E),M=(A[Math.floor(.98*(A.length-1))]??1)/y*100*1.15||1,w=`Residuals of ${r.name}: computed less measured, in percent of the measured root mean square, over theta_h; relative RMS ${ut(100*this.relativeRms,3)} %`;this.rest.begin(w,{low:0,high:90,ticks:[0,15,30,45,60,75,90],label:"θ_h (°)"},{low:-M,high:M,label:"residual (%)"}),p.forEach(({tint:T},E)=>this.rest.dots(g.map(x=>pi(r.thetaH[x])),g.map(x=>v[E][x]/y*100),T)),this.restWords.textContent=`Computed less measured, in percent of the measured root mean square. Relative RMS ${ut(100*this.relativeRms,3)} % over ${f.toLocaleString("en")} samples${r.hours.length>1?` of scan ${s+1}`:""}.${r.note?` ${r.note}`:""}`}nearest(e,t){let n=NaN;for(let r=0;r<e.count;r+=1){let s=pi(e.thetaI[r]);if(!(Math.abs(s-t)>=Math.abs(n-t))&&Na(e,s,1).length&&(n=s),r>400&&Number.isFinite(n))break}return Number.isFinite(n)?`${ut(n,3)}°`:"none"}};var Pp=0,au=1,Lp=2;var Wo=1,Np=2,Ns=3,Qn=0,un=1,Nn=2,Vr=0,Ds=1,lu=2,cu=3,hu=4,Dp=5;var Wr=100,Fp=101,Up=102,Op=103,Bp=104,kp=200,zp=201,Hp=202,Gp=203,uu=204,fu=205,Vp=206,Wp=207,$p=208,Xp=209,qp=210,Yp=211,Zp=212,Kp=213,Jp=214,cl=0,hl=1,ul=2,_s=3,fl=4,dl=5,pl=6,ml=7,du=0,jp=1,Qp=2,wi=0,$o=1,pu=2,mu=3,gu=4,vu=5,Xo=6,Fs=7,Zh="attached",em="detached",_u=300,$r=301,Us=302,Fl=303,Ul=304,yr=1e3,Rn=1001,ys=1002,Mt=1003,Ol=1004;var Xr=1005;var Rt=1006,Os=1007;var Wn=1008;var Dn=1009,yu=1010,xu=1011,Bs=1012,Bl=1013,ci=1014,yt=1015,Jt=1016,kl=1017,zl=1018,qr=1020,bu=35902,Mu=35899,Su=1021,wu=1022,xt=1023,Wi=1026,tr=1027,nr=1028,Hl=1029,Fn=1030,Gl=1031;var Vl=1033,qo=33776,Yo=33777,Zo=33778,Ko=33779,Wl=35840,$l=35841,Xl=35842,ql=35843,Yl=36196,Zl=37492,Kl=37496,Jl=37488,jl=37489,Jo=37490,Ql=37491,ec=37808,tc=37809,nc=37810,ic=37811,rc=37812,sc=37813,oc=37814,ac=37815,lc=37816,cc=37817,hc=37818,uc=37819,fc=37820,dc=37821,pc=36492,mc=36494,gc=36495,vc=36283,_c=36284,jo=36285,yc=36286;var Dr=2300,Fr=2301,al=2302,Kh=2303,Jh=2400,jh=2401,Qh=2402,tm=2500;var Au=0,Qo=1,ks=2,nm=3200;var xc=0,im=1,ir="",Xt="srgb",Lt="srgb-linear",_o="linear",bt="srgb";var ll=7680;var rm=519,sm=512,om=513,am=514,Tu=515,lm=516,cm=517,Eu=518,Ru=519,Cu=35044;var nn="300 es",jn=2e3,xs=2001;function pv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function mv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function bs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function hm(){let i=bs("canvas");return i.style.display="block",i}var Wd={},Ms=null;function yo(...i){let e="THREE."+i.shift();Ms?Ms("log",e,...i):console.log(e,...i)}function um(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function ke(...i){i=um(i);let e="THREE."+i.shift();if(Ms)Ms("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Je(...i){i=um(i);let e="THREE."+i.shift();if(Ms)Ms("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Nr(...i){let e=i.join(" ");e in Wd||(Wd[e]=!0,ke(...i))}function fm(i,e,t){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:n()}}setTimeout(s,t)})}var dm={[cl]:cl,[ul]:pl,[fl]:fl,[_s]:dl,[hl]:hl,[pl]:ul,[ml]:ml,[dl]:_s},bi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},pn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],$d=1234567,go=Math.PI/180,Ur=180/Math.PI;function Ai(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(pn[i&255]+pn[i>>8&255]+pn[i>>16&255]+pn[i>>24&255]+"-"+pn[e&255]+pn[e>>8&255]+"-"+pn[e>>16&15|64]+pn[e>>24&255]+"-"+pn[t&63|128]+pn[t>>8&255]+"-"+pn[t>>16&255]+pn[t>>24&255]+pn[n&255]+pn[n>>8&255]+pn[n>>16&255]+pn[n>>24&255]).toLowerCase()}function ct(i,e,t){return Math.max(e,Math.min(t,i))}function Iu(i,e){return(i%e+e)%e}function gv(i,e,t,n,r){return n+(i-e)*(r-n)/(t-e)}function vv(i,e,t){return i!==e?(t-i)/(e-i):0}function vo(i,e,t){return(1-t)*i+t*e}function _v(i,e,t,n){return vo(i,e,1-Math.exp(-t*n))}function yv(i,e=1){return e-Math.abs(Iu(i,e*2)-e)}function xv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function bv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Mv(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Sv(i,e){return i+Math.random()*(e-i)}function wv(i){return i*(.5-Math.random())}function Av(i){i!==void 0&&($d=i);let e=$d+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Tv(i){return i*go}function Ev(i){return i*Ur}function Rv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Cv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Pu(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Iv(i,e,t,n,r){let s=Math.cos,o=Math.sin,a=s(t/2),l=o(t/2),c=s((e+n)/2),h=o((e+n)/2),u=s((e-n)/2),f=o((e-n)/2),p=s((n-e)/2),v=o((n-e)/2);switch(r){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*v,l*p,a*c);break;case"YXY":i.set(l*p,a*h,l*v,a*c);break;case"ZYZ":i.set(l*v,l*p,a*h,a*c);break;default:ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function bc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Lu(i,e){if(e.constructor===Float32Array)return i;let t=bc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Nu(i,e){if(e.constructor===Float32Array)return i;let t=bc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Mc={DEG2RAD:go,RAD2DEG:Ur,generateUUID:Ai,clamp:ct,euclideanModulo:Iu,mapLinear:gv,inverseLerp:vv,lerp:vo,damp:_v,pingpong:yv,smoothstep:xv,smootherstep:bv,randInt:Mv,randFloat:Sv,randFloatSpread:wv,seededRandom:Av,degToRad:Tv,radToDeg:Ev,isPowerOfTwo:Rv,ceilPowerOfTwo:Cv,floorPowerOfTwo:Pu,setQuaternionFromProperEuler:Iv,normalize:Nu,denormalize:Lu},it=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*n-o*r+e.x,this.y=s*r+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},zn=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,s,o,a){let l=n[r+0],c=n[r+1],h=n[r+2],u=n[r+3],f=s[o+0],p=s[o+1],v=s[o+2],y=s[o+3];if(u!==y||l!==f||c!==p||h!==v){let m=l*f+c*p+h*v+u*y;m<0&&(f=-f,p=-p,v=-v,y=-y,m=-m);let g=1-a;if(m<.9995){let A=Math.acos(m),M=Math.sin(A);g=Math.sin(g*A)/M,a=Math.sin(a*A)/M,l=l*g+f*a,c=c*g+p*a,h=h*g+v*a,u=u*g+y*a}else{l=l*g+f*a,c=c*g+p*a,h=h*g+v*a,u=u*g+y*a;let A=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=A,c*=A,h*=A,u*=A}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,r,s,o){let a=n[r],l=n[r+1],c=n[r+2],h=n[r+3],u=s[o],f=s[o+1],p=s[o+2],v=s[o+3];return e[t]=a*v+h*u+l*p-c*f,e[t+1]=l*v+h*f+c*u-a*p,e[t+2]=c*v+h*p+a*f-l*u,e[t+3]=h*v-a*u-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(r/2),u=a(s/2),f=l(n/2),p=l(r/2),v=l(s/2);switch(o){case"XYZ":this._x=f*h*u+c*p*v,this._y=c*p*u-f*h*v,this._z=c*h*v+f*p*u,this._w=c*h*u-f*p*v;break;case"YXZ":this._x=f*h*u+c*p*v,this._y=c*p*u-f*h*v,this._z=c*h*v-f*p*u,this._w=c*h*u+f*p*v;break;case"ZXY":this._x=f*h*u-c*p*v,this._y=c*p*u+f*h*v,this._z=c*h*v+f*p*u,this._w=c*h*u-f*p*v;break;case"ZYX":this._x=f*h*u-c*p*v,this._y=c*p*u+f*h*v,this._z=c*h*v-f*p*u,this._w=c*h*u+f*p*v;break;case"YZX":this._x=f*h*u+c*p*v,this._y=c*p*u+f*h*v,this._z=c*h*v-f*p*u,this._w=c*h*u-f*p*v;break;case"XZY":this._x=f*h*u-c*p*v,this._y=c*p*u-f*h*v,this._z=c*h*v+f*p*u,this._w=c*h*u+f*p*v;break;default:ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=n+a+u;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(s-c)*p,this._z=(o-r)*p}else if(n>a&&n>u){let p=2*Math.sqrt(1+n-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+c)/p}else if(a>u){let p=2*Math.sqrt(1+a-n-u);this._w=(s-c)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+u-n-a);this._w=(o-r)/p,this._x=(s+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+r*c-s*l,this._y=r*h+o*l+s*a-n*c,this._z=s*h+o*c+n*l-r*a,this._w=o*h-n*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Xd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Xd.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6]*r,this.y=s[1]*t+s[4]*n+s[7]*r,this.z=s[2]*t+s[5]*n+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*n),h=2*(a*t-s*r),u=2*(s*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-s*u,this.z=r+l*u+s*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*n+s[8]*r,this.y=s[1]*t+s[5]*n+s[9]*r,this.z=s[2]*t+s[6]*n+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-n*l,this.z=n*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return wh.copy(this).projectOnVector(e),this.sub(wh)}reflect(e){return this.sub(wh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},wh=new W,Xd=new zn,Ke=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,a,l,c)}set(e,t,n,r,s,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],p=n[5],v=n[8],y=r[0],m=r[3],g=r[6],A=r[1],M=r[4],w=r[7],T=r[2],E=r[5],x=r[8];return s[0]=o*y+a*A+l*T,s[3]=o*m+a*M+l*E,s[6]=o*g+a*w+l*x,s[1]=c*y+h*A+u*T,s[4]=c*m+h*M+u*E,s[7]=c*g+h*w+u*x,s[2]=f*y+p*A+v*T,s[5]=f*m+p*M+v*E,s[8]=f*g+p*w+v*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*s*h+n*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,f=a*l-h*s,p=c*s-o*l,v=t*u+n*f+r*p;if(v===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/v;return e[0]=u*y,e[1]=(r*c-h*n)*y,e[2]=(a*n-r*o)*y,e[3]=f*y,e[4]=(h*t-r*l)*y,e[5]=(r*s-a*t)*y,e[6]=p*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*s)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Nr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ah.makeScale(e,t)),this}rotate(e){return Nr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ah.makeRotation(-e)),this}translate(e,t){return Nr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ah.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ah=new Ke,qd=new Ke().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Yd=new Ke().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Pv(){let i={enabled:!0,workingColorSpace:Lt,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===bt&&(r.r=Vi(r.r),r.g=Vi(r.g),r.b=Vi(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===bt&&(r.r=vs(r.r),r.g=vs(r.g),r.b=vs(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===ir?_o:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Lt]:{primaries:e,whitePoint:n,transfer:_o,toXYZ:qd,fromXYZ:Yd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Xt},outputColorSpaceConfig:{drawingBufferColorSpace:Xt}},[Xt]:{primaries:e,whitePoint:n,transfer:bt,toXYZ:qd,fromXYZ:Yd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Xt}}}),i}var st=Pv();function Vi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function vs(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var is,gl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{is===void 0&&(is=bs("canvas")),is.width=e.width,is.height=e.height;let r=is.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=is}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=bs("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Vi(s[o]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Vi(t[n]/255)*255):t[n]=Vi(t[n]);return{data:t,width:e.width,height:e.height}}else return ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Lv=0,Ss=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Lv++}),this.uuid=Ai(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Th(r[o].image)):s.push(Th(r[o]))}else s=Th(r);n.url=s}return t||(e.images[this.uuid]=n),n}};function Th(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?gl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(ke("Texture: Unable to serialize Texture."),{})}var Nv=0,Eh=new W,cn=class i extends bi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Rn,r=Rn,s=Rt,o=Wn,a=xt,l=Dn,c=i.DEFAULT_ANISOTROPY,h=ir){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Nv++}),this.uuid=Ai(),this.name="",this.source=new Ss(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ke,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Eh).x}get height(){return this.source.getSize(Eh).y}get depth(){return this.source.getSize(Eh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){ke(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==_u)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case yr:e.x=e.x-Math.floor(e.x);break;case Rn:e.x=e.x<0?0:1;break;case ys:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case yr:e.y=e.y-Math.floor(e.y);break;case Rn:e.y=e.y<0?0:1;break;case ys:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};cn.DEFAULT_IMAGE=null;cn.DEFAULT_MAPPING=_u;cn.DEFAULT_ANISOTROPY=1;var Tt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*n+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,s,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],p=l[5],v=l[9],y=l[2],m=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-y)<.01&&Math.abs(v-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+y)<.1&&Math.abs(v+m)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,w=(p+1)/2,T=(g+1)/2,E=(h+f)/4,x=(u+y)/4,b=(v+m)/4;return M>w&&M>T?M<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(M),r=E/n,s=x/n):w>T?w<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(w),n=E/r,s=b/r):T<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(T),n=x/s,r=b/s),this.set(n,r,s,t),this}let A=Math.sqrt((m-v)*(m-v)+(u-y)*(u-y)+(f-h)*(f-h));return Math.abs(A)<.001&&(A=1),this.x=(m-v)/A,this.y=(u-y)/A,this.z=(f-h)/A,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},vl=class extends bi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Rt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Tt(0,0,e,t),this.scissorTest=!1,this.viewport=new Tt(0,0,e,t),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new cn({width:e,height:t,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Rt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Ss(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},tn=class extends vl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},xo=class extends cn{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Mt,this.minFilter=Mt,this.wrapR=Rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var _l=class extends cn{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Mt,this.minFilter=Mt,this.wrapR=Rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var et=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,s,o,a,l,c,h,u,f,p,v,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,a,l,c,h,u,f,p,v,y,m)}set(e,t,n,r,s,o,a,l,c,h,u,f,p,v,y,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=r,g[1]=s,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=f,g[3]=p,g[7]=v,g[11]=y,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/rs.setFromMatrixColumn(e,0).length(),s=1/rs.setFromMatrixColumn(e,1).length(),o=1/rs.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*s,t[5]=n[5]*s,t[6]=n[6]*s,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,s=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),u=Math.sin(s);if(e.order==="XYZ"){let f=o*h,p=o*u,v=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=p+v*c,t[5]=f-y*c,t[9]=-a*l,t[2]=y-f*c,t[6]=v+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*h,p=l*u,v=c*h,y=c*u;t[0]=f+y*a,t[4]=v*a-p,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=p*a-v,t[6]=y+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*h,p=l*u,v=c*h,y=c*u;t[0]=f-y*a,t[4]=-o*u,t[8]=v+p*a,t[1]=p+v*a,t[5]=o*h,t[9]=y-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*h,p=o*u,v=a*h,y=a*u;t[0]=l*h,t[4]=v*c-p,t[8]=f*c+y,t[1]=l*u,t[5]=y*c+f,t[9]=p*c-v,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,v=a*l,y=a*c;t[0]=l*h,t[4]=y-f*u,t[8]=v*u+p,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=p*u+v,t[10]=f-y*u}else if(e.order==="XZY"){let f=o*l,p=o*c,v=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+y,t[5]=o*h,t[9]=p*u-v,t[2]=v*u-p,t[6]=a*h,t[10]=y*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Dv,e,Fv)}lookAt(e,t,n){let r=this.elements;return On.subVectors(e,t),On.lengthSq()===0&&(On.z=1),On.normalize(),fr.crossVectors(n,On),fr.lengthSq()===0&&(Math.abs(n.z)===1?On.x+=1e-4:On.z+=1e-4,On.normalize(),fr.crossVectors(n,On)),fr.normalize(),Fa.crossVectors(On,fr),r[0]=fr.x,r[4]=Fa.x,r[8]=On.x,r[1]=fr.y,r[5]=Fa.y,r[9]=On.y,r[2]=fr.z,r[6]=Fa.z,r[10]=On.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],p=n[13],v=n[2],y=n[6],m=n[10],g=n[14],A=n[3],M=n[7],w=n[11],T=n[15],E=r[0],x=r[4],b=r[8],P=r[12],I=r[1],F=r[5],B=r[9],z=r[13],D=r[2],$=r[6],q=r[10],K=r[14],fe=r[3],J=r[7],ae=r[11],ce=r[15];return s[0]=o*E+a*I+l*D+c*fe,s[4]=o*x+a*F+l*$+c*J,s[8]=o*b+a*B+l*q+c*ae,s[12]=o*P+a*z+l*K+c*ce,s[1]=h*E+u*I+f*D+p*fe,s[5]=h*x+u*F+f*$+p*J,s[9]=h*b+u*B+f*q+p*ae,s[13]=h*P+u*z+f*K+p*ce,s[2]=v*E+y*I+m*D+g*fe,s[6]=v*x+y*F+m*$+g*J,s[10]=v*b+y*B+m*q+g*ae,s[14]=v*P+y*z+m*K+g*ce,s[3]=A*E+M*I+w*D+T*fe,s[7]=A*x+M*F+w*$+T*J,s[11]=A*b+M*B+w*q+T*ae,s[15]=A*P+M*z+w*K+T*ce,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],p=e[14],v=e[3],y=e[7],m=e[11],g=e[15],A=l*p-c*f,M=a*p-c*u,w=a*f-l*u,T=o*p-c*h,E=o*f-l*h,x=o*u-a*h;return t*(y*A-m*M+g*w)-n*(v*A-m*T+g*E)+r*(v*M-y*T+g*x)-s*(v*w-y*E+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(s*h-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],p=e[11],v=e[12],y=e[13],m=e[14],g=e[15],A=t*a-n*o,M=t*l-r*o,w=t*c-s*o,T=n*l-r*a,E=n*c-s*a,x=r*c-s*l,b=h*y-u*v,P=h*m-f*v,I=h*g-p*v,F=u*m-f*y,B=u*g-p*y,z=f*g-p*m,D=A*z-M*B+w*F+T*I-E*P+x*b;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let $=1/D;return e[0]=(a*z-l*B+c*F)*$,e[1]=(r*B-n*z-s*F)*$,e[2]=(y*x-m*E+g*T)*$,e[3]=(f*E-u*x-p*T)*$,e[4]=(l*I-o*z-c*P)*$,e[5]=(t*z-r*I+s*P)*$,e[6]=(m*w-v*x-g*M)*$,e[7]=(h*x-f*w+p*M)*$,e[8]=(o*B-a*I+c*b)*$,e[9]=(n*I-t*B-s*b)*$,e[10]=(v*E-y*w+g*A)*$,e[11]=(u*w-h*E-p*A)*$,e[12]=(a*P-o*F-l*b)*$,e[13]=(t*F-n*P+r*b)*$,e[14]=(y*M-v*T-m*A)*$,e[15]=(h*T-u*M+f*A)*$,this}scale(e){let t=this.elements,n=e.x,r=e.y,s=e.z;return t[0]*=n,t[4]*=r,t[8]*=s,t[1]*=n,t[5]*=r,t[9]*=s,t[2]*=n,t[6]*=r,t[10]*=s,t[3]*=n,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),s=1-n,o=e.x,a=e.y,l=e.z,c=s*o,h=s*a;return this.set(c*o+n,c*a-r*l,c*l+r*a,0,c*a+r*l,h*a+n,h*l-r*o,0,c*l-r*a,h*l+r*o,s*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,s,o){return this.set(1,n,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,h=o+o,u=a+a,f=s*c,p=s*h,v=s*u,y=o*h,m=o*u,g=a*u,A=l*c,M=l*h,w=l*u,T=n.x,E=n.y,x=n.z;return r[0]=(1-(y+g))*T,r[1]=(p+w)*T,r[2]=(v-M)*T,r[3]=0,r[4]=(p-w)*E,r[5]=(1-(f+g))*E,r[6]=(m+A)*E,r[7]=0,r[8]=(v+M)*x,r[9]=(m-A)*x,r[10]=(1-(f+y))*x,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),t.identity(),this;let o=rs.set(r[0],r[1],r[2]).length(),a=rs.set(r[4],r[5],r[6]).length(),l=rs.set(r[8],r[9],r[10]).length();s<0&&(o=-o),ii.copy(this);let c=1/o,h=1/a,u=1/l;return ii.elements[0]*=c,ii.elements[1]*=c,ii.elements[2]*=c,ii.elements[4]*=h,ii.elements[5]*=h,ii.elements[6]*=h,ii.elements[8]*=u,ii.elements[9]*=u,ii.elements[10]*=u,t.setFromRotationMatrix(ii),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,r,s,o,a=jn,l=!1){let c=this.elements,h=2*s/(t-e),u=2*s/(n-r),f=(t+e)/(t-e),p=(n+r)/(n-r),v,y;if(l)v=s/(o-s),y=o*s/(o-s);else if(a===jn)v=-(o+s)/(o-s),y=-2*o*s/(o-s);else if(a===xs)v=-o/(o-s),y=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=v,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,r,s,o,a=jn,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-r),f=-(t+e)/(t-e),p=-(n+r)/(n-r),v,y;if(l)v=1/(o-s),y=o/(o-s);else if(a===jn)v=-2/(o-s),y=-(o+s)/(o-s);else if(a===xs)v=-1/(o-s),y=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=v,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},rs=new W,ii=new et,Dv=new W(0,0,0),Fv=new W(1,1,1),fr=new W,Fa=new W,On=new W,Zd=new et,Kd=new zn,$i=class i{constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],h=r[9],u=r[2],f=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,s),this._z=0);break;case"ZXY":this._x=Math.asin(ct(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,p),this._y=0);break;default:ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Zd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Zd,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Kd.setFromEuler(this),this.setFromQuaternion(Kd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};$i.DEFAULT_ORDER="XYZ";var bo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Uv=0,Jd=new W,ss=new zn,Ui=new et,Ua=new W,oo=new W,Ov=new W,Bv=new zn,jd=new W(1,0,0),Qd=new W(0,1,0),ep=new W(0,0,1),tp={type:"added"},kv={type:"removed"},os={type:"childadded",child:null},Rh={type:"childremoved",child:null},Ht=class i extends bi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Uv++}),this.uuid=Ai(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new W,t=new $i,n=new zn,r=new W(1,1,1);function s(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new et},normalMatrix:{value:new Ke}}),this.matrix=new et,this.matrixWorld=new et,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new bo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ss.setFromAxisAngle(e,t),this.quaternion.multiply(ss),this}rotateOnWorldAxis(e,t){return ss.setFromAxisAngle(e,t),this.quaternion.premultiply(ss),this}rotateX(e){return this.rotateOnAxis(jd,e)}rotateY(e){return this.rotateOnAxis(Qd,e)}rotateZ(e){return this.rotateOnAxis(ep,e)}translateOnAxis(e,t){return Jd.copy(e).applyQuaternion(this.quaternion),this.position.add(Jd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(jd,e)}translateY(e){return this.translateOnAxis(Qd,e)}translateZ(e){return this.translateOnAxis(ep,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ui.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ua.copy(e):Ua.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),oo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ui.lookAt(oo,Ua,this.up):Ui.lookAt(Ua,oo,this.up),this.quaternion.setFromRotationMatrix(Ui),r&&(Ui.extractRotation(r.matrixWorld),ss.setFromRotationMatrix(Ui),this.quaternion.premultiply(ss.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Je("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(tp),os.child=e,this.dispatchEvent(os),os.child=null):Je("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(kv),Rh.child=e,this.dispatchEvent(Rh),Rh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ui.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ui.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ui),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(tp),os.child=e,this.dispatchEvent(os),os.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(oo,e,Ov),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(oo,Bv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*n-s[8]*r,s[13]+=n-s[1]*t-s[5]*n-s[9]*r,s[14]+=r-s[2]*t-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];s(e.shapes,u)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),f=o(e.skeletons),p=o(e.animations),v=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),v.length>0&&(n.nodes=v)}return n.object=r,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ht.DEFAULT_UP=new W(0,1,0);Ht.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ht.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Ht{constructor(){super(),this.isGroup=!0,this.type="Group"}},zv={type:"move"},ws=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),g=this._getHandJoint(c,y);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),p=.02,v=.005;c.inputState.pinching&&f>p+v?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-v&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(zv)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new kn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},pm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},dr={h:0,s:0,l:0},Oa={h:0,s:0,l:0};function Ch(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var $e=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Xt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,st.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=st.workingColorSpace){return this.r=e,this.g=t,this.b=n,st.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=st.workingColorSpace){if(e=Iu(e,1),t=ct(t,0,1),n=ct(n,0,1),t===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+t):n+t-n*t,o=2*n-s;this.r=Ch(o,s,e+1/3),this.g=Ch(o,s,e),this.b=Ch(o,s,e-1/3)}return st.colorSpaceToWorking(this,r),this}setStyle(e,t=Xt){function n(s){s!==void 0&&parseFloat(s)<1&&ke("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:ke("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Xt){let n=pm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Vi(e.r),this.g=Vi(e.g),this.b=Vi(e.b),this}copyLinearToSRGB(e){return this.r=vs(e.r),this.g=vs(e.g),this.b=vs(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Xt){return st.workingToColorSpace(mn.copy(this),e),Math.round(ct(mn.r*255,0,255))*65536+Math.round(ct(mn.g*255,0,255))*256+Math.round(ct(mn.b*255,0,255))}getHexString(e=Xt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=st.workingColorSpace){st.workingToColorSpace(mn.copy(this),t);let n=mn.r,r=mn.g,s=mn.b,o=Math.max(n,r,s),a=Math.min(n,r,s),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(r-s)/u+(r<s?6:0);break;case r:l=(s-n)/u+2;break;case s:l=(n-r)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=st.workingColorSpace){return st.workingToColorSpace(mn.copy(this),t),e.r=mn.r,e.g=mn.g,e.b=mn.b,e}getStyle(e=Xt){st.workingToColorSpace(mn.copy(this),e);let t=mn.r,n=mn.g,r=mn.b;return e!==Xt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(dr),this.setHSL(dr.h+e,dr.s+t,dr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(dr),e.getHSL(Oa);let n=vo(dr.h,Oa.h,t),r=vo(dr.s,Oa.s,t),s=vo(dr.l,Oa.l,t);return this.setHSL(n,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*n+s[6]*r,this.g=s[1]*t+s[4]*n+s[7]*r,this.b=s[2]*t+s[5]*n+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},mn=new $e;$e.NAMES=pm;var Cn=class extends Ht{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new $i,this.environmentIntensity=1,this.environmentRotation=new $i,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ri=new W,Oi=new W,Ih=new W,Bi=new W,as=new W,ls=new W,np=new W,Ph=new W,Lh=new W,Nh=new W,Dh=new Tt,Fh=new Tt,Uh=new Tt,_r=class i{constructor(e=new W,t=new W,n=new W){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),ri.subVectors(e,t),r.cross(ri);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,n,r,s){ri.subVectors(r,t),Oi.subVectors(n,t),Ih.subVectors(e,t);let o=ri.dot(ri),a=ri.dot(Oi),l=ri.dot(Ih),c=Oi.dot(Oi),h=Oi.dot(Ih),u=o*c-a*a;if(u===0)return s.set(0,0,0),null;let f=1/u,p=(c*l-a*h)*f,v=(o*h-a*l)*f;return s.set(1-p-v,v,p)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,Bi)===null?!1:Bi.x>=0&&Bi.y>=0&&Bi.x+Bi.y<=1}static getInterpolation(e,t,n,r,s,o,a,l){return this.getBarycoord(e,t,n,r,Bi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Bi.x),l.addScaledVector(o,Bi.y),l.addScaledVector(a,Bi.z),l)}static getInterpolatedAttribute(e,t,n,r,s,o){return Dh.setScalar(0),Fh.setScalar(0),Uh.setScalar(0),Dh.fromBufferAttribute(e,t),Fh.fromBufferAttribute(e,n),Uh.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Dh,s.x),o.addScaledVector(Fh,s.y),o.addScaledVector(Uh,s.z),o}static isFrontFacing(e,t,n,r){return ri.subVectors(n,t),Oi.subVectors(e,t),ri.cross(Oi).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ri.subVectors(this.c,this.b),Oi.subVectors(this.a,this.b),ri.cross(Oi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,s){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,s)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,s=this.c,o,a;as.subVectors(r,n),ls.subVectors(s,n),Ph.subVectors(e,n);let l=as.dot(Ph),c=ls.dot(Ph);if(l<=0&&c<=0)return t.copy(n);Lh.subVectors(e,r);let h=as.dot(Lh),u=ls.dot(Lh);if(h>=0&&u<=h)return t.copy(r);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(as,o);Nh.subVectors(e,s);let p=as.dot(Nh),v=ls.dot(Nh);if(v>=0&&p<=v)return t.copy(s);let y=p*c-l*v;if(y<=0&&c>=0&&v<=0)return a=c/(c-v),t.copy(n).addScaledVector(ls,a);let m=h*v-p*u;if(m<=0&&u-h>=0&&p-v>=0)return np.subVectors(s,r),a=(u-h)/(u-h+(p-v)),t.copy(r).addScaledVector(np,a);let g=1/(m+y+f);return o=y*g,a=f*g,t.copy(n).addScaledVector(as,o).addScaledVector(ls,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Hn=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(si.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(si.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=si.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let s=n.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,si):si.fromBufferAttribute(s,o),si.applyMatrix4(e.matrixWorld),this.expandByPoint(si);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ba.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ba.copy(n.boundingBox)),Ba.applyMatrix4(e.matrixWorld),this.union(Ba)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,si),si.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ao),ka.subVectors(this.max,ao),cs.subVectors(e.a,ao),hs.subVectors(e.b,ao),us.subVectors(e.c,ao),pr.subVectors(hs,cs),mr.subVectors(us,hs),Cr.subVectors(cs,us);let t=[0,-pr.z,pr.y,0,-mr.z,mr.y,0,-Cr.z,Cr.y,pr.z,0,-pr.x,mr.z,0,-mr.x,Cr.z,0,-Cr.x,-pr.y,pr.x,0,-mr.y,mr.x,0,-Cr.y,Cr.x,0];return!Oh(t,cs,hs,us,ka)||(t=[1,0,0,0,1,0,0,0,1],!Oh(t,cs,hs,us,ka))?!1:(za.crossVectors(pr,mr),t=[za.x,za.y,za.z],Oh(t,cs,hs,us,ka))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,si).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(si).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ki[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ki[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ki[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ki[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ki[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ki[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ki[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ki[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ki),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ki=[new W,new W,new W,new W,new W,new W,new W,new W],si=new W,Ba=new Hn,cs=new W,hs=new W,us=new W,pr=new W,mr=new W,Cr=new W,ao=new W,ka=new W,za=new W,Ir=new W;function Oh(i,e,t,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){Ir.fromArray(i,s);let a=r.x*Math.abs(Ir.x)+r.y*Math.abs(Ir.y)+r.z*Math.abs(Ir.z),l=e.dot(Ir),c=t.dot(Ir),h=n.dot(Ir);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Gi=Hv();function Hv(){let i=new ArrayBuffer(4),e=new Float32Array(i),t=new Uint32Array(i),n=new Uint32Array(512),r=new Uint32Array(512);for(let l=0;l<256;++l){let c=l-127;c<-27?(n[l]=0,n[l|256]=32768,r[l]=24,r[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,r[l]=-c-1,r[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,r[l]=13,r[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,r[l]=24,r[l|256]=24):(n[l]=31744,n[l|256]=64512,r[l]=13,r[l|256]=13)}let s=new Uint32Array(2048),o=new Uint32Array(64),a=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,h=0;for(;(c&8388608)===0;)c<<=1,h-=8388608;c&=-8388609,h+=947912704,s[l]=c|h}for(let l=1024;l<2048;++l)s[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(a[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:r,mantissaTable:s,exponentTable:o,offsetTable:a}}function Gv(i){Math.abs(i)>65504&&ke("DataUtils.toHalfFloat(): Value out of range."),i=ct(i,-65504,65504),Gi.floatView[0]=i;let e=Gi.uint32View[0],t=e>>23&511;return Gi.baseTable[t]+((e&8388607)>>Gi.shiftTable[t])}function Vv(i){let e=i>>10;return Gi.uint32View[0]=Gi.mantissaTable[Gi.offsetTable[e]+(i&1023)]+Gi.exponentTable[e],Gi.floatView[0]}var xe=class{static toHalfFloat(e){return Gv(e)}static fromHalfFloat(e){return Vv(e)}},Qt=new W,Ha=new it,Wv=0,ht=class extends bi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Wv++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Cu,this.updateRanges=[],this.gpuType=yt,this.version=0,this._normalizationScale=e!==void 0?bc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ha.fromBufferAttribute(this,t),Ha.applyMatrix3(e),this.setXY(t,Ha.x,Ha.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.applyMatrix3(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.applyMatrix4(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.applyNormalMatrix(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Qt.fromBufferAttribute(this,t),Qt.transformDirection(e),this.setXYZ(t,Qt.x,Qt.y,Qt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lu(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Nu(e,this.array)}},Mo=class extends ht{constructor(e,t,n){super(new Int8Array(e),t,n)}},So=class extends ht{constructor(e,t,n){super(new Uint8Array(e),t,n)}};var wo=class extends ht{constructor(e,t,n){super(new Int16Array(e),t,n)}},Or=class extends ht{constructor(e,t,n){super(new Uint16Array(e),t,n)}},Ao=class extends ht{constructor(e,t,n){super(new Int32Array(e),t,n)}},Br=class extends ht{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var zt=class extends ht{constructor(e,t,n){super(new Float32Array(e),t,n)}},$v=new Hn,lo=new W,Bh=new W,In=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):$v.setFromPoints(e).getCenter(n);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,n.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;lo.subVectors(e,this.center);let t=lo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(lo,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Bh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(lo.copy(e.center).add(Bh)),this.expandByPoint(lo.copy(e.center).sub(Bh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Xv=0,Jn=new et,kh=new Ht,fs=new W,Bn=new Hn,co=new Hn,ln=new W,Nt=class i extends bi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Xv++}),this.uuid=Ai(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(pv(e)?Br:Or)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new Ke().getNormalMatrix(e);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Jn.makeRotationFromQuaternion(e),this.applyMatrix4(Jn),this}rotateX(e){return Jn.makeRotationX(e),this.applyMatrix4(Jn),this}rotateY(e){return Jn.makeRotationY(e),this.applyMatrix4(Jn),this}rotateZ(e){return Jn.makeRotationZ(e),this.applyMatrix4(Jn),this}translate(e,t,n){return Jn.makeTranslation(e,t,n),this.applyMatrix4(Jn),this}scale(e,t,n){return Jn.makeScale(e,t,n),this.applyMatrix4(Jn),this}lookAt(e){return kh.lookAt(e),kh.updateMatrix(),this.applyMatrix4(kh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(fs).negate(),this.translate(fs.x,fs.y,fs.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new zt(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Hn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Je("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let s=t[n];Bn.setFromBufferAttribute(s),this.morphTargetsRelative?(ln.addVectors(this.boundingBox.min,Bn.min),this.boundingBox.expandByPoint(ln),ln.addVectors(this.boundingBox.max,Bn.max),this.boundingBox.expandByPoint(ln)):(this.boundingBox.expandByPoint(Bn.min),this.boundingBox.expandByPoint(Bn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Je('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new In);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Je("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let n=this.boundingSphere.center;if(Bn.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];co.setFromBufferAttribute(a),this.morphTargetsRelative?(ln.addVectors(Bn.min,co.min),Bn.expandByPoint(ln),ln.addVectors(Bn.max,co.max),Bn.expandByPoint(ln)):(Bn.expandByPoint(co.min),Bn.expandByPoint(co.max))}Bn.getCenter(n);let r=0;for(let s=0,o=e.count;s<o;s++)ln.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(ln));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)ln.fromBufferAttribute(a,c),l&&(fs.fromBufferAttribute(e,c),ln.add(fs)),r=Math.max(r,n.distanceToSquared(ln))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&Je('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Je("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new ht(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let P=0;P<n.count;P++)a[P]=new W,l[P]=new W;let h=new W,u=new W,f=new W,p=new it,v=new it,y=new it,m=new W,g=new W;function A(P,I,F){c[P]=c[I]=c[F]=1,h.fromBufferAttribute(n,P),u.fromBufferAttribute(n,I),f.fromBufferAttribute(n,F),p.fromBufferAttribute(s,P),v.fromBufferAttribute(s,I),y.fromBufferAttribute(s,F),u.sub(h),f.sub(h),v.sub(p),y.sub(p);let B=1/(v.x*y.y-y.x*v.y);isFinite(B)&&(m.copy(u).multiplyScalar(y.y).addScaledVector(f,-v.y).multiplyScalar(B),g.copy(f).multiplyScalar(v.x).addScaledVector(u,-y.x).multiplyScalar(B),a[P].add(m),a[I].add(m),a[F].add(m),l[P].add(g),l[I].add(g),l[F].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let P=0,I=M.length;P<I;++P){let F=M[P],B=F.start,z=F.count;for(let D=B,$=B+z;D<$;D+=3)A(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let w=new W,T=new W,E=new W,x=new W;function b(P){E.fromBufferAttribute(r,P),x.copy(E);let I=a[P];w.copy(I),w.sub(E.multiplyScalar(E.dot(I))).normalize(),T.crossVectors(x,I);let B=T.dot(l[P])<0?-1:1;o.setXYZW(P,w.x,w.y,w.z,B)}for(let P=0,I=n.count;P<I;++P)c[P]&&b(P);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new ht(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let r=new W,s=new W,o=new W,a=new W,l=new W,c=new W,h=new W,u=new W;if(e)for(let f=0,p=e.count;f<p;f+=3){let v=e.getX(f+0),y=e.getX(f+1),m=e.getX(f+2);r.fromBufferAttribute(t,v),s.fromBufferAttribute(t,y),o.fromBufferAttribute(t,m),h.subVectors(o,s),u.subVectors(r,s),h.cross(u),a.fromBufferAttribute(n,v),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(v,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,s),u.subVectors(r,s),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)ln.fromBufferAttribute(e,t),ln.normalize(),e.setXYZ(t,ln.x,ln.y,ln.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),p=0,v=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?p=l[y]*a.data.stride+a.offset:p=l[y]*h;for(let g=0;g<h;g++)f[v++]=c[p++]}return new ht(f,h,u)}if(this.index===null)return ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,n);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],p=e(f,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let p=c[u];h.push(p.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],u=s[c];for(let f=0,p=u.length;f<p;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},As=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Cu,this.updateRanges=[],this.version=0,this.uuid=Ai()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[n+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=ip(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=ip(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function ip(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ai()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Sn=new W,Ts=class i{constructor(e,t,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=r,this._normalizationScale=e!==void 0?bc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix4(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.applyNormalMatrix(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Sn.fromBufferAttribute(this,t),Sn.transformDirection(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){yo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new ht(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){yo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lu(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Nu(e,this.data.array)}},zh=new W,qv=new W,Yv=new Ke,oi=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=zh.subVectors(n,t).cross(qv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(zh),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Yv.getNormalMatrix(e),r=this.coplanarPoint(zh).applyMatrix4(e),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Zv=0,Pn=class extends bi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zv++}),this.uuid=Ai(),this.name="",this.type="Material",this.blending=Ds,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=uu,this.blendDst=fu,this.blendEquation=Wr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new $e(0,0,0),this.blendAlpha=0,this.depthFunc=_s,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ll,this.stencilZFail=ll,this.stencilZPass=ll,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){ke(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new $e().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new oi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new it().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=t[s].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var zi=new W,Hh=new W,Ga=new W,Va=new W,kr=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,zi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=zi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(zi.copy(this.origin).addScaledVector(this.direction,t),zi.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){Hh.copy(e).add(t).multiplyScalar(.5),Ga.copy(t).sub(e).normalize(),Va.copy(this.origin).sub(Hh);let s=e.distanceTo(t)*.5,o=-this.direction.dot(Ga),a=Va.dot(this.direction),l=-Va.dot(Ga),c=Va.lengthSq(),h=Math.abs(1-o*o),u,f,p,v;if(h>0)if(u=o*l-a,f=o*a-l,v=s*h,u>=0)if(f>=-v)if(f<=v){let y=1/h;u*=y,f*=y,p=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=s,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f=-s,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f<=-v?(u=Math.max(0,-(-o*s+a)),f=u>0?-s:Math.min(Math.max(-s,-l),s),p=-u*u+f*(f+2*l)+c):f<=v?(u=0,f=Math.min(Math.max(-s,-l),s),p=f*(f+2*l)+c):(u=Math.max(0,-(o*s+a)),f=u>0?s:Math.min(Math.max(-s,-l),s),p=-u*u+f*(f+2*l)+c);else f=o>0?-s:s,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),r&&r.copy(Hh).addScaledVector(Ga,f),p}intersectSphere(e,t){if(e.radius<0)return null;zi.subVectors(e.center,this.origin);let n=zi.dot(this.direction),r=zi.dot(zi)-n*n,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,s,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),h>=0?(s=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(s=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),u>=0?(a=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(a=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),n>l||a>r)||((a>n||n!==n)&&(n=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,zi)!==null}intersectTriangle(e,t,n,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,f=e.y-o.y,p=e.z-o.z,v=t.x-o.x,y=t.y-o.y,m=t.z-o.z,g=n.x-o.x,A=n.y-o.y,M=n.z-o.z,w=Math.abs(l),T=Math.abs(c),E=Math.abs(h),x,b,P,I,F,B,z,D,$,q,K,fe;if(w>=T&&w>=E?(P=l,B=u,$=v,fe=g,l>=0?(x=c,b=h,I=f,F=p,z=y,D=m,q=A,K=M):(x=h,b=c,I=p,F=f,z=m,D=y,q=M,K=A)):T>=E?(P=c,B=f,$=y,fe=A,c>=0?(x=h,b=l,I=p,F=u,z=m,D=v,q=M,K=g):(x=l,b=h,I=u,F=p,z=v,D=m,q=g,K=M)):(P=h,B=p,$=m,fe=M,h>=0?(x=l,b=c,I=u,F=f,z=v,D=y,q=g,K=A):(x=c,b=l,I=f,F=u,z=y,D=v,q=A,K=g)),P===0)return null;let J=x/P,ae=b/P,ce=1/P,we=I-J*B,De=F-ae*B,ie=z-J*$,Re=D-ae*$,Ue=q-J*fe,ze=K-ae*fe,me=Ue*Re-ze*ie,Xe=we*ze-De*Ue,wt=ie*De-Re*we;if(r){if(me<0||Xe<0||wt<0)return null}else if((me<0||Xe<0||wt<0)&&(me>0||Xe>0||wt>0))return null;let Ve=me+Xe+wt;if(Ve===0)return null;let ft=ce*(me*B+Xe*$+wt*fe);return(Ve>0?ft<0:ft>0)?null:this.at(ft/Ve,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ai=class extends Pn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new $e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new $i,this.combine=du,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},rp=new et,Pr=new kr,Wa=new In,sp=new W,$a=new W,Xa=new W,qa=new W,Gh=new W,Ya=new W,op=new W,Za=new W,St=class extends Ht{constructor(e=new Nt,t=new ai){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){Ya.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=a[l],u=s[l];h!==0&&(Gh.fromBufferAttribute(u,e),o?Ya.addScaledVector(Gh,h):Ya.addScaledVector(Gh.sub(t),h))}t.add(Ya)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Wa.copy(n.boundingSphere),Wa.applyMatrix4(s),Pr.copy(e.ray).recast(e.near),!(Wa.containsPoint(Pr.origin)===!1&&(Pr.intersectSphere(Wa,sp)===null||Pr.origin.distanceToSquared(sp)>(e.far-e.near)**2))&&(rp.copy(s).invert(),Pr.copy(e.ray).applyMatrix4(rp),!(n.boundingBox!==null&&Pr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Pr)))}_computeIntersections(e,t,n){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,u=s.attributes.normal,f=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let v=0,y=f.length;v<y;v++){let m=f[v],g=o[m.materialIndex],A=Math.max(m.start,p.start),M=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let w=A,T=M;w<T;w+=3){let E=a.getX(w),x=a.getX(w+1),b=a.getX(w+2);r=Ka(this,g,e,n,c,h,u,E,x,b),r&&(r.faceIndex=Math.floor(w/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let v=Math.max(0,p.start),y=Math.min(a.count,p.start+p.count);for(let m=v,g=y;m<g;m+=3){let A=a.getX(m),M=a.getX(m+1),w=a.getX(m+2);r=Ka(this,o,e,n,c,h,u,A,M,w),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let v=0,y=f.length;v<y;v++){let m=f[v],g=o[m.materialIndex],A=Math.max(m.start,p.start),M=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let w=A,T=M;w<T;w+=3){let E=w,x=w+1,b=w+2;r=Ka(this,g,e,n,c,h,u,E,x,b),r&&(r.faceIndex=Math.floor(w/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let v=Math.max(0,p.start),y=Math.min(l.count,p.start+p.count);for(let m=v,g=y;m<g;m+=3){let A=m,M=m+1,w=m+2;r=Ka(this,o,e,n,c,h,u,A,M,w),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}}};function Kv(i,e,t,n,r,s,o,a){let l;if(e.side===un?l=n.intersectTriangle(o,s,r,!0,a):l=n.intersectTriangle(r,s,o,e.side===Qn,a),l===null)return null;Za.copy(a),Za.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Za);return c<t.near||c>t.far?null:{distance:c,point:Za.clone(),object:i}}function Ka(i,e,t,n,r,s,o,a,l,c){i.getVertexPosition(a,$a),i.getVertexPosition(l,Xa),i.getVertexPosition(c,qa);let h=Kv(i,e,t,n,$a,Xa,qa,op);if(h){let u=new W;_r.getBarycoord(op,$a,Xa,qa,u),r&&(h.uv=_r.getInterpolatedAttribute(r,a,l,c,u,new it)),s&&(h.uv1=_r.getInterpolatedAttribute(s,a,l,c,u,new it)),o&&(h.normal=_r.getInterpolatedAttribute(o,a,l,c,u,new W),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};_r.getNormal($a,Xa,qa,f.normal),h.face=f,h.barycoord=u}return h}var ho=new Tt,ap=new Tt,lp=new Tt,Jv=new Tt,cp=new et,Ja=new W,Vh=new In,hp=new et,Wh=new kr,To=class extends St{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Zh,this.bindMatrix=new et,this.bindMatrixInverse=new et,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new Hn),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Ja),this.boundingBox.expandByPoint(Ja)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new In),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Ja),this.boundingSphere.expandByPoint(Ja)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,r=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Vh.copy(this.boundingSphere),Vh.applyMatrix4(r),e.ray.intersectsSphere(Vh)!==!1&&(hp.copy(r).invert(),Wh.copy(e.ray).applyMatrix4(hp),!(this.boundingBox!==null&&Wh.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,Wh)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new Tt,t=this.geometry.attributes.skinWeight;for(let n=0,r=t.count;n<r;n++){e.fromBufferAttribute(t,n);let s=1/e.manhattanLength();s!==1/0?e.multiplyScalar(s):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===Zh?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===em?this.bindMatrixInverse.copy(this.bindMatrix).invert():ke("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,r=this.geometry;ap.fromBufferAttribute(r.attributes.skinIndex,e),lp.fromBufferAttribute(r.attributes.skinWeight,e),t.isVector4?(ho.copy(t),t.set(0,0,0,0)):(ho.set(t.x,t.y,t.z,1),t.set(0,0,0)),ho.applyMatrix4(this.bindMatrix);for(let s=0;s<4;s++){let o=lp.getComponent(s);if(o!==0){let a=ap.getComponent(s);cp.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(Jv.copy(ho).applyMatrix4(cp),o)}}return t.isVector4&&(t.w=ho.w),t.applyMatrix4(this.bindMatrixInverse)}},Es=class extends Ht{constructor(){super(),this.isBone=!0,this.type="Bone"}},gn=class extends cn{constructor(e=null,t=1,n=1,r,s,o,a,l,c=Mt,h=Mt,u,f){super(null,o,a,l,c,h,r,s,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},up=new et,jv=new et,Eo=class i{constructor(e=[],t=[]){this.uuid=Ai(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){ke("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,r=this.bones.length;n<r;n++)this.boneInverses.push(new et)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new et;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,r=this.boneTexture;for(let s=0,o=e.length;s<o;s++){let a=e[s]?e[s].matrixWorld:jv;up.multiplyMatrices(a,t[s]),up.toArray(n,s*16)}r!==null&&(r.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new gn(t,e,e,xt,yt);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let r=this.bones[t];if(r.name===e)return r}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,r=e.bones.length;n<r;n++){let s=e.bones[n],o=t[s];o===void 0&&(ke("Skeleton: No bone found with UUID:",s),o=new Es),this.bones.push(o),this.boneInverses.push(new et().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let r=0,s=t.length;r<s;r++){let o=t[r];e.bones.push(o.uuid);let a=n[r];e.boneInverses.push(a.toArray())}return e}},Xi=class extends ht{constructor(e,t,n,r=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},ds=new et,fp=new et,ja=[],dp=new Hn,Qv=new et,uo=new St,fo=new In,Ro=class extends St{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Xi(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<n;r++)this.setMatrixAt(r,Qv)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Hn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,ds),dp.copy(e.boundingBox).applyMatrix4(ds),this.boundingBox.union(dp)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new In),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,ds),fo.copy(e.boundingSphere).applyMatrix4(ds),this.boundingSphere.union(fo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=n.length+1,o=e*s+1;for(let a=0;a<n.length;a++)n[a]=r[o+a]}raycast(e,t){let n=this.matrixWorld,r=this.count;if(uo.geometry=this.geometry,uo.material=this.material,uo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),fo.copy(this.boundingSphere),fo.applyMatrix4(n),e.ray.intersectsSphere(fo)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,ds),fp.multiplyMatrices(n,ds),uo.matrixWorld=fp,uo.raycast(e,ja);for(let o=0,a=ja.length;o<a;o++){let l=ja[o];l.instanceId=s,l.object=this,t.push(l)}ja.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Xi(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,r=n.length+1;this.morphTexture===null&&(this.morphTexture=new gn(new Float32Array(r*this.count),r,this.count,nr,yt));let s=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=r*e;return s[l]=a,s.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Lr=new In,e_=new it(.5,.5),Qa=new W,xr=class{constructor(e=new oi,t=new oi,n=new oi,r=new oi,s=new oi,o=new oi){this.planes=[e,t,n,r,s,o]}set(e,t,n,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=jn,n=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],h=s[4],u=s[5],f=s[6],p=s[7],v=s[8],y=s[9],m=s[10],g=s[11],A=s[12],M=s[13],w=s[14],T=s[15];if(r[0].setComponents(c-o,p-h,g-v,T-A).normalize(),r[1].setComponents(c+o,p+h,g+v,T+A).normalize(),r[2].setComponents(c+a,p+u,g+y,T+M).normalize(),r[3].setComponents(c-a,p-u,g-y,T-M).normalize(),n)r[4].setComponents(l,f,m,w).normalize(),r[5].setComponents(c-l,p-f,g-m,T-w).normalize();else if(r[4].setComponents(c-l,p-f,g-m,T-w).normalize(),t===jn)r[5].setComponents(c+l,p+f,g+m,T+w).normalize();else if(t===xs)r[5].setComponents(l,f,m,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Lr)}intersectsSprite(e){Lr.center.set(0,0,0);let t=e_.distanceTo(e.center);return Lr.radius=.7071067811865476+t,Lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Lr)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(Qa.x=r.normal.x>0?e.max.x:e.min.x,Qa.y=r.normal.y>0?e.max.y:e.min.y,Qa.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Qa)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},pp=new et,yl=class i{constructor(){this.coordinateSystem=jn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];pp.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new xr),n[r].setFromProjectionMatrix(pp,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new xr),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var qi=class extends Pn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new $e(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},xl=new W,bl=new W,mp=new et,po=new kr,el=new In,$h=new W,gp=new W,Mi=class extends Ht{constructor(e=new Nt,t=new qi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let r=1,s=t.count;r<s;r++)xl.fromBufferAttribute(t,r-1),bl.fromBufferAttribute(t,r),n[r]=n[r-1],n[r]+=xl.distanceTo(bl);e.setAttribute("lineDistance",new zt(n,1))}else ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,s=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),el.copy(n.boundingSphere),el.applyMatrix4(r),el.radius+=s,e.ray.intersectsSphere(el)===!1)return;mp.copy(r).invert(),po.copy(e.ray).applyMatrix4(mp);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let p=Math.max(0,o.start),v=Math.min(h.count,o.start+o.count);for(let y=p,m=v-1;y<m;y+=c){let g=h.getX(y),A=h.getX(y+1),M=tl(this,e,po,l,g,A,y);M&&t.push(M)}if(this.isLineLoop){let y=h.getX(v-1),m=h.getX(p),g=tl(this,e,po,l,y,m,v-1);g&&t.push(g)}}else{let p=Math.max(0,o.start),v=Math.min(f.count,o.start+o.count);for(let y=p,m=v-1;y<m;y+=c){let g=tl(this,e,po,l,y,y+1,y);g&&t.push(g)}if(this.isLineLoop){let y=tl(this,e,po,l,v-1,p,v-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function tl(i,e,t,n,r,s,o){let a=i.geometry.attributes.position;if(xl.fromBufferAttribute(a,r),bl.fromBufferAttribute(a,s),t.distanceSqToSegment(xl,bl,$h,gp)>n)return;$h.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo($h);if(!(c<e.near||c>e.far))return{distance:c,point:gp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var vp=new W,_p=new W,Co=class extends Mi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let r=0,s=t.count;r<s;r+=2)vp.fromBufferAttribute(t,r),_p.fromBufferAttribute(t,r+1),n[r]=r===0?0:n[r-1],n[r+1]=n[r]+vp.distanceTo(_p);e.setAttribute("lineDistance",new zt(n,1))}else ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},zr=class extends Mi{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Rs=class extends Pn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new $e(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},yp=new et,eu=new kr,nl=new In,il=new W,Io=class extends Ht{constructor(e=new Nt,t=new Rs){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,s=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),nl.copy(n.boundingSphere),nl.applyMatrix4(r),nl.radius+=s,e.ray.intersectsSphere(nl)===!1)return;yp.copy(r).invert(),eu.copy(e.ray).applyMatrix4(yp);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let f=Math.max(0,o.start),p=Math.min(c.count,o.start+o.count);for(let v=f,y=p;v<y;v++){let m=c.getX(v);il.fromBufferAttribute(u,m),xp(il,m,l,r,e,t,this)}}else{let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let v=f,y=p;v<y;v++)il.fromBufferAttribute(u,v),xp(il,v,l,r,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function xp(i,e,t,n,r,s,o){let a=eu.distanceSqToPoint(i);if(a<t){let l=new W;eu.closestPointToPoint(i,l),l.applyMatrix4(n);let c=r.ray.origin.distanceTo(l);if(c<r.near||c>r.far)return;s.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Po=class extends cn{constructor(e=[],t=$r,n,r,s,o,a,l,c,h){super(e,t,n,r,s,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Yi=class extends cn{constructor(e,t,n=ci,r,s,o,a=Mt,l=Mt,c,h=Wi,u=1){if(h!==Wi&&h!==tr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,r,s,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ss(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Lo=class extends Yi{constructor(e,t=ci,n=$r,r,s,o=Mt,a=Mt,l,c=Wi){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,r,s,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},No=class extends cn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Cs=class i extends Nt{constructor(e=1,t=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,p=0;v("z","y","x",-1,-1,n,t,e,o,s,0),v("z","y","x",1,-1,n,t,-e,o,s,1),v("x","z","y",1,1,e,n,t,r,o,2),v("x","z","y",1,-1,e,n,-t,r,o,3),v("x","y","z",1,-1,e,t,n,r,s,4),v("x","y","z",-1,-1,e,t,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new zt(c,3)),this.setAttribute("normal",new zt(h,3)),this.setAttribute("uv",new zt(u,2));function v(y,m,g,A,M,w,T,E,x,b,P){let I=w/x,F=T/b,B=w/2,z=T/2,D=E/2,$=x+1,q=b+1,K=0,fe=0,J=new W;for(let ae=0;ae<q;ae++){let ce=ae*F-z;for(let we=0;we<$;we++){let De=we*I-B;J[y]=De*A,J[m]=ce*M,J[g]=D,c.push(J.x,J.y,J.z),J[y]=0,J[m]=0,J[g]=E>0?1:-1,h.push(J.x,J.y,J.z),u.push(we/x),u.push(1-ae/b),K+=1}}for(let ae=0;ae<b;ae++)for(let ce=0;ce<x;ce++){let we=f+ce+$*ae,De=f+ce+$*(ae+1),ie=f+(ce+1)+$*(ae+1),Re=f+(ce+1)+$*ae;l.push(we,De,Re),l.push(De,ie,Re),fe+=6}a.addGroup(p,fe,P),p+=fe,f+=K}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ml=class i extends Nt{constructor(e=1,t=1,n=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let h=[],u=[],f=[],p=[],v=0,y=[],m=n/2,g=0;A(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new zt(u,3)),this.setAttribute("normal",new zt(f,3)),this.setAttribute("uv",new zt(p,2));function A(){let w=new W,T=new W,E=0,x=(t-e)/n;for(let b=0;b<=s;b++){let P=[],I=b/s,F=I*(t-e)+e;for(let B=0;B<=r;B++){let z=B/r,D=z*l+a,$=Math.sin(D),q=Math.cos(D);T.x=F*$,T.y=-I*n+m,T.z=F*q,u.push(T.x,T.y,T.z),w.set($,x,q).normalize(),f.push(w.x,w.y,w.z),p.push(z,1-I),P.push(v++)}y.push(P)}for(let b=0;b<r;b++)for(let P=0;P<s;P++){let I=y[P][b],F=y[P+1][b],B=y[P+1][b+1],z=y[P][b+1];(e>0||P!==0)&&(h.push(I,F,z),E+=3),(t>0||P!==s-1)&&(h.push(F,B,z),E+=3)}c.addGroup(g,E,0),g+=E}function M(w){let T=v,E=new it,x=new W,b=0,P=w===!0?e:t,I=w===!0?1:-1;for(let B=1;B<=r;B++)u.push(0,m*I,0),f.push(0,I,0),p.push(.5,.5),v++;let F=v;for(let B=0;B<=r;B++){let D=B/r*l+a,$=Math.cos(D),q=Math.sin(D);x.x=P*q,x.y=m*I,x.z=P*$,u.push(x.x,x.y,x.z),f.push(0,I,0),E.x=$*.5+.5,E.y=q*.5*I+.5,p.push(E.x,E.y),v++}for(let B=0;B<r;B++){let z=T+B,D=F+B;w===!0?h.push(D,D+1,z):h.push(D+1,D,z),b+=3}c.addGroup(g,b,w===!0?1:2),g+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Sl=class i extends Ml{constructor(e=1,t=1,n=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,n,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var li=class i extends Nt{constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(n),l=Math.floor(r),c=a+1,h=l+1,u=e/a,f=t/l,p=[],v=[],y=[],m=[];for(let g=0;g<h;g++){let A=g*f-o;for(let M=0;M<c;M++){let w=M*u-s;v.push(w,-A,0),y.push(0,0,1),m.push(M/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let A=0;A<a;A++){let M=A+c*g,w=A+c*(g+1),T=A+1+c*(g+1),E=A+1+c*g;p.push(M,w,E),p.push(w,T,E)}this.setIndex(p),this.setAttribute("position",new zt(v,3)),this.setAttribute("normal",new zt(y,3)),this.setAttribute("uv",new zt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Do=class i extends Nt{constructor(e=1,t=32,n=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new W,f=new W,p=[],v=[],y=[],m=[];for(let g=0;g<=n;g++){let A=[],M=g/n,w=o+M*a,T=e*Math.cos(w),E=Math.sqrt(e*e-T*T),x=0;g===0&&o===0?x=.5/t:g===n&&l===Math.PI&&(x=-.5/t);for(let b=0;b<=t;b++){let P=b/t,I=r+P*s;u.x=-E*Math.cos(I),u.y=T,u.z=E*Math.sin(I),v.push(u.x,u.y,u.z),f.copy(u).normalize(),y.push(f.x,f.y,f.z),m.push(P+x,1-M),A.push(c++)}h.push(A)}for(let g=0;g<n;g++)for(let A=0;A<t;A++){let M=h[g][A+1],w=h[g][A],T=h[g+1][A],E=h[g+1][A+1];(g!==0||o>0)&&p.push(M,w,E),(g!==n-1||l<Math.PI)&&p.push(w,T,E)}this.setIndex(p),this.setAttribute("position",new zt(v,3)),this.setAttribute("normal",new zt(y,3)),this.setAttribute("uv",new zt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Yr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(bp(r))r.isRenderTargetTexture?(ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(bp(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][n]=s}else e[t][n]=r.slice();else e[t][n]=r}}return e}function vn(i){let e={};for(let t=0;t<i.length;t++){let n=Yr(i[t]);for(let r in n)e[r]=n[r]}return e}function bp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function t_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Du(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:st.workingColorSpace}var mm={clone:Yr,merge:vn},n_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,i_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ft=class extends Pn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=n_,this.fragmentShader=i_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Yr(e.uniforms),this.uniformsGroups=t_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new $e().setHex(r.value);break;case"v2":this.uniforms[n].value=new it().fromArray(r.value);break;case"v3":this.uniforms[n].value=new W().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Tt().fromArray(r.value);break;case"m3":this.uniforms[n].value=new Ke().fromArray(r.value);break;case"m4":this.uniforms[n].value=new et().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},wl=class extends Ft{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Hr=class extends Pn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new $e(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new $e(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=xc,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new $i,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},wn=class extends Hr{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new it(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return ct(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new $e(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new $e(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new $e(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Nr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Nr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var Al=class extends Pn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=nm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Tl=class extends Pn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function vr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function mo(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function r_(i){function e(r,s){return i[r]-i[s]}let t=i.length,n=new Array(t);for(let r=0;r!==t;++r)n[r]=r;return n.sort(e),n}function Mp(i,e,t){let n=i.length,r=new i.constructor(n);for(let s=0,o=0;o!==n;++s){let a=t[s]*e;for(let l=0;l!==e;++l)r[o++]=i[a+l]}return r}function s_(i,e,t,n){let r=1,s=i[0];for(;s!==void 0&&s[n]===void 0;)s=i[r++];if(s===void 0)return;let o=s[n];if(o!==void 0)if(Array.isArray(o))do o=s[n],o!==void 0&&(e.push(s.time),t.push(...o)),s=i[r++];while(s!==void 0);else if(o.toArray!==void 0)do o=s[n],o!==void 0&&(e.push(s.time),o.toArray(t,t.length)),s=i[r++];while(s!==void 0);else do o=s[n],o!==void 0&&(e.push(s.time),t.push(o)),s=i[r++];while(s!==void 0)}var Si=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],s=t[n-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=n+2;;){if(r===void 0){if(e<s)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=r,r=t[++n],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=t[--n-1],e>=s)break t}o=n,n=0;break n}break e}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(r=t[n],s=t[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=n[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},El=class extends Si{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Jh,endingEnd:Jh}}intervalChanged_(e,t,n){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case jh:s=e,a=2*t-n;break;case Qh:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case jh:o=e,l=2*n-t;break;case Qh:o=1,l=n+r[1]-r[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=s*h,this._offsetNext=o*h}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,p=this._weightNext,v=(n-t)/(r-t),y=v*v,m=y*v,g=-f*m+2*f*y-f*v,A=(1+f)*m+(-1.5-2*f)*y+(-.5+f)*v+1,M=(-1-p)*m+(1.5+p)*y+.5*v,w=p*m-p*y;for(let T=0;T!==a;++T)s[T]=g*o[h+T]+A*o[c+T]+M*o[l+T]+w*o[u+T];return s}},Rl=class extends Si{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(r-t),u=1-h;for(let f=0;f!==a;++f)s[f]=o[c+f]*u+o[l+f]*h;return s}},Cl=class extends Si{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Il=class extends Si{interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let v=(n-t)/(r-t),y=1-v;for(let m=0;m!==a;++m)s[m]=o[c+m]*y+o[l+m]*v;return s}let f=a*2,p=e-1;for(let v=0;v!==a;++v){let y=o[c+v],m=o[l+v],g=p*f+v*2,A=u[g],M=u[g+1],w=e*f+v*2,T=h[w],E=h[w+1],x=a_(n,t,A,T,r);s[v]=gm(x,y,M,E,m)}return s}};function gm(i,e,t,n,r){let s=1-i;return s*s*s*e+3*s*s*i*t+3*s*i*i*n+i*i*i*r}function o_(i,e,t,n,r){let s=1-i;return 3*s*s*(t-e)+6*s*i*(n-t)+3*i*i*(r-n)}function a_(i,e,t,n,r){let s=(i-e)/(r-e);for(let o=0;o<8;o++){let a=gm(s,e,t,n,r)-i;if(Math.abs(a)<1e-10)break;let l=o_(s,e,t,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Ln=class{constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=vr(t,this.TimeBufferType),this.values=vr(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:vr(e.times,Array),values:vr(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),mo(e.settings)&&(n.settings={inTangents:vr(e.settings.inTangents,Array),outTangents:vr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Cl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Rl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new El(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Il(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Dr:t=this.InterpolantFactoryMethodDiscrete;break;case Fr:t=this.InterpolantFactoryMethodLinear;break;case al:t=this.InterpolantFactoryMethodSmooth;break;case Kh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Dr;case this.InterpolantFactoryMethodLinear:return Fr;case this.InterpolantFactoryMethodSmooth:return al;case this.InterpolantFactoryMethodBezier:return Kh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;mo(this.settings)&&(Sp(this.settings.inTangents,e),Sp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;mo(this.settings)&&(wp(this.settings.inTangents,e),wp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<e;)++s;for(;o!==-1&&n[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Je("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,s=n.length;s===0&&(Je("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Je("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Je("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&mv(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){Je("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===al,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(r)l=!0;else{let u=a*n,f=u-n,p=u+n;for(let v=0;v!==n;++v){let y=t[u+v];if(y!==t[f+v]||y!==t[p+v]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,f=o*n;for(let p=0;p!==n;++p)t[f+p]=t[u+p]}++o}}if(s>0){e[o]=e[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,mo(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Sp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function wp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Ln.prototype.ValueTypeName="";Ln.prototype.TimeBufferType=Float32Array;Ln.prototype.ValueBufferType=Float32Array;Ln.prototype.DefaultInterpolation=Fr;var Zi=class extends Ln{constructor(e,t,n){super(e,t,n)}};Zi.prototype.ValueTypeName="bool";Zi.prototype.ValueBufferType=Array;Zi.prototype.DefaultInterpolation=Dr;Zi.prototype.InterpolantFactoryMethodLinear=void 0;Zi.prototype.InterpolantFactoryMethodSmooth=void 0;var Fo=class extends Ln{constructor(e,t,n,r){super(e,t,n,r)}};Fo.prototype.ValueTypeName="color";var Ki=class extends Ln{constructor(e,t,n,r){super(e,t,n,r)}};Ki.prototype.ValueTypeName="number";var Pl=class extends Si{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(r-t),c=e*a;for(let h=c+a;c!==h;c+=4)zn.slerpFlat(s,0,o,c-a,o,c,l);return s}},Ji=class extends Ln{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new Pl(this.times,this.values,this.getValueSize(),e)}};Ji.prototype.ValueTypeName="quaternion";Ji.prototype.InterpolantFactoryMethodSmooth=void 0;var ji=class extends Ln{constructor(e,t,n){super(e,t,n)}};ji.prototype.ValueTypeName="string";ji.prototype.ValueBufferType=Array;ji.prototype.DefaultInterpolation=Dr;ji.prototype.InterpolantFactoryMethodLinear=void 0;ji.prototype.InterpolantFactoryMethodSmooth=void 0;var br=class extends Ln{constructor(e,t,n,r){super(e,t,n,r)}};br.prototype.ValueTypeName="vector";var Uo=class{constructor(e="",t=-1,n=[],r=tm){this.name=e,this.tracks=n,this.duration=t,this.blendMode=r,this.uuid=Ai(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,r=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push(c_(n[o]).scale(r));let s=new this(e.name,e.duration,t,e.blendMode);return s.uuid=e.uuid,s.userData=JSON.parse(e.userData||"{}"),s}static toJSON(e){let t=[],n=e.tracks,r={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let s=0,o=n.length;s!==o;++s)t.push(Ln.toJSON(n[s]));return r}static CreateFromMorphTargetSequence(e,t,n,r){let s=t.length,o=[];for(let a=0;a<s;a++){let l=[],c=[];l.push((a+s-1)%s,a,(a+1)%s),c.push(0,1,0);let h=r_(l);l=Mp(l,1,h),c=Mp(c,1,h),!r&&l[0]===0&&(l.push(s),c.push(c[0])),o.push(new Ki(".morphTargetInfluences["+t[a].name+"]",l,c).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let r=e;n=r.geometry&&r.geometry.animations||r.animations}for(let r=0;r<n.length;r++)if(n[r].name===t)return n[r];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let r={},s=/^([\w-]*?)([\d]+)$/;for(let a=0,l=e.length;a<l;a++){let c=e[a],h=c.name.match(s);if(h&&h.length>1){let u=h[1],f=r[u];f||(r[u]=f=[]),f.push(c)}}let o=[];for(let a in r)o.push(this.CreateFromMorphTargetSequence(a,r[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,r=e.length;n!==r;++n){let s=this.tracks[n];t=Math.max(t,s.times[s.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function l_(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Ki;case"vector":case"vector2":case"vector3":case"vector4":return br;case"color":return Fo;case"quaternion":return Ji;case"bool":case"boolean":return Zi;case"string":return ji}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function c_(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=l_(i.type);if(i.times===void 0){let n=[],r=[];s_(i.keys,n,r,"value"),i.times=n,i.values=r}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),mo(i.settings)&&(t.settings={inTangents:vr(i.settings.inTangents,Float32Array),outTangents:vr(i.settings.outTangents,Float32Array)}),t}var xi={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(Ap(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!Ap(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function Ap(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Ll=class{constructor(e,t,n){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,s===!1&&r.onStart!==void 0&&r.onStart(h,o,a),s=!0},this.itemEnd=function(h){o++,r.onProgress!==void 0&&r.onProgress(h,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let p=c[u],v=c[u+1];if(p.global&&(p.lastIndex=0),p.test(h))return v}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},vm=new Ll,Gn=class{constructor(e){this.manager=e!==void 0?e:vm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,s){n.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Gn.DEFAULT_MATERIAL_NAME="__DEFAULT";var Hi={},tu=class extends Error{constructor(e,t){super(e),this.response=t}},Qi=class extends Gn{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,r){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let s=xi.get(`file:${e}`);if(s!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(s),this.manager.itemEnd(e)},0);return}if(Hi[e]!==void 0){Hi[e].push({onLoad:t,onProgress:n,onError:r});return}Hi[e]=[],Hi[e].push({onLoad:t,onProgress:n,onError:r});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&ke("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let h=Hi[e],u=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),p=f?parseInt(f):0,v=p!==0,y=0,m=new ReadableStream({start(g){A();function A(){u.read().then(({done:M,value:w})=>{if(M)g.close();else{y+=w.byteLength;let T=new ProgressEvent("progress",{lengthComputable:v,loaded:y,total:p});for(let E=0,x=h.length;E<x;E++){let b=h[E];b.onProgress&&b.onProgress(T)}g.enqueue(w),A()}},M=>{g.error(M)})}}});return new Response(m)}else throw new tu(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return c.json();default:if(a==="")return c.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),f=u&&u[1]?u[1].toLowerCase():void 0,p=new TextDecoder(f);return c.arrayBuffer().then(v=>p.decode(v))}}}).then(c=>{xi.add(`file:${e}`,c);let h=Hi[e];delete Hi[e];for(let u=0,f=h.length;u<f;u++){let p=h[u];p.onLoad&&p.onLoad(c)}}).catch(c=>{let h=Hi[e];if(h===void 0)throw this.manager.itemError(e),c;delete Hi[e];for(let u=0,f=h.length;u<f;u++){let p=h[u];p.onError&&p.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var ps=new WeakMap,Nl=class extends Gn{constructor(e){super(e)}load(e,t,n,r){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let s=this,o=xi.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)s.manager.itemStart(e),setTimeout(function(){t&&t(o),s.manager.itemEnd(e)},0);else{let u=ps.get(o);u===void 0&&(u=[],ps.set(o,u)),u.push({onLoad:t,onError:r})}return o}let a=bs("img");function l(){h(),t&&t(this);let u=ps.get(this)||[];for(let f=0;f<u.length;f++){let p=u[f];p.onLoad&&p.onLoad(this)}ps.delete(this),s.manager.itemEnd(e)}function c(u){h(),r&&r(u),xi.remove(`image:${e}`);let f=ps.get(this)||[];for(let p=0;p<f.length;p++){let v=f[p];v.onError&&v.onError(u)}ps.delete(this),s.manager.itemError(e),s.manager.itemEnd(e)}function h(){a.removeEventListener("load",l,!1),a.removeEventListener("error",c,!1)}return a.addEventListener("load",l,!1),a.addEventListener("error",c,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),xi.add(`image:${e}`,a),s.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var Gr=class extends Gn{constructor(e){super(e)}load(e,t,n,r){let s=this,o=new gn,a=new Qi(this.manager);return a.setPriority(this.priority),a.setCache(this.cache),a.setResponseType("arraybuffer"),a.setRequestHeader(this.requestHeader),a.setPath(this.path),a.setWithCredentials(s.withCredentials),a.load(e,function(l){let c;try{c=s.parse(l)}catch(h){r!==void 0?r(h):Je(h);return}s._applyTexData(o,c),t&&t(o,c)},n,r),o}createDataTexture(e){let t=new gn;return this._applyTexData(t,this.parse(e)),t}_applyTexData(e,t){t.image!==void 0?e.image=t.image:t.data!==void 0&&(e.image.width=t.width,e.image.height=t.height,e.image.data=t.data),e.wrapS=t.wrapS!==void 0?t.wrapS:Rn,e.wrapT=t.wrapT!==void 0?t.wrapT:Rn,e.magFilter=t.magFilter!==void 0?t.magFilter:Rt,e.minFilter=t.minFilter!==void 0?t.minFilter:Rt,e.anisotropy=t.anisotropy!==void 0?t.anisotropy:1,t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.mipmaps!==void 0&&(e.mipmaps=t.mipmaps,e.minFilter=Wn),t.mipmapCount===1&&(e.minFilter=Rt),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),e.needsUpdate=!0}},Oo=class extends Gn{constructor(e){super(e)}load(e,t,n,r){let s=new cn,o=new Nl(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){s.image=a,s.needsUpdate=!0,t!==void 0&&t(s)},n,r),s}},Is=class extends Ht{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new $e(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Xh=new et,Tp=new W,Ep=new W,Ps=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new it(512,512),this.mapType=Dn,this.map=null,this.mapPass=null,this.matrix=new et,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new xr,this._frameExtents=new it(1,1),this._viewportCount=1,this._viewports=[new Tt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Tp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Tp),Ep.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Ep),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,r){Xh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Xh,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===xs||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Xh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},rl=new W,sl=new zn,yi=new W,Bo=class extends Ht{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new et,this.projectionMatrix=new et,this.projectionMatrixInverse=new et,this.coordinateSystem=jn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(rl,sl,yi),yi.x===1&&yi.y===1&&yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(rl,sl,yi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(rl,sl,yi),yi.x===1&&yi.y===1&&yi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(rl,sl,yi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},gr=new W,Rp=new it,Cp=new it,Kt=class extends Bo{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ur*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(go*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ur*2*Math.atan(Math.tan(go*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){gr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(gr.x,gr.y).multiplyScalar(-e/gr.z),gr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(gr.x,gr.y).multiplyScalar(-e/gr.z)}getViewSize(e,t){return this.getViewBounds(e,Rp,Cp),t.subVectors(Cp,Rp)}setViewOffset(e,t,n,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(go*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*n/c,r*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},nu=class extends Ps{constructor(){super(new Kt(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Ur*2*e.angle*this.focus,r=this.mapSize.width/this.mapSize.height*this.aspect,s=e.distance||t.far;(n!==t.fov||r!==t.aspect||s!==t.far)&&(t.fov=n,t.aspect=r,t.far=s,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},ko=class extends Is{constructor(e,t,n=0,r=Math.PI/3,s=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(Ht.DEFAULT_UP),this.updateMatrix(),this.target=new Ht,this.distance=n,this.angle=r,this.penumbra=s,this.decay=o,this.map=null,this.shadow=new nu}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},iu=class extends Ps{constructor(){super(new Kt(90,1,.5,500)),this.isPointLightShadow=!0}},zo=class extends Is{constructor(e,t,n=0,r=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=r,this.shadow=new iu}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Vn=class extends Bo{constructor(e=-1,t=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-e,o=n+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},ru=class extends Ps{constructor(){super(new Vn(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ho=class extends Is{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ht.DEFAULT_UP),this.updateMatrix(),this.target=new Ht,this.shadow=new ru}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var er=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}};var qh=new WeakMap,Go=class extends Gn{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&ke("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&ke("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,r){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let s=this,o=xi.get(`image-bitmap:${e}`);if(o!==void 0){if(s.manager.itemStart(e),o.then){o.then(c=>{qh.has(o)===!0?(r&&r(qh.get(o)),s.manager.itemError(e),s.manager.itemEnd(e)):(t&&t(c),s.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),s.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let l=fetch(e,a).then(function(c){return c.blob()}).then(function(c){return createImageBitmap(c,Object.assign({},s.options,{colorSpaceConversion:"none"}))}).then(function(c){return xi.add(`image-bitmap:${e}`,c),t&&t(c),s.manager.itemEnd(e),c}).catch(function(c){r&&r(c),qh.set(l,c),xi.remove(`image-bitmap:${e}`),s.manager.itemError(e),s.manager.itemEnd(e)});xi.add(`image-bitmap:${e}`,l),s.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var ms=-90,gs=1,Ls=class extends Ht{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Kt(ms,gs,e,t);r.layers=this.layers,this.add(r);let s=new Kt(ms,gs,e,t);s.layers=this.layers,this.add(s);let o=new Kt(ms,gs,e,t);o.layers=this.layers,this.add(o);let a=new Kt(ms,gs,e,t);a.layers=this.layers,this.add(a);let l=new Kt(ms,gs,e,t);l.layers=this.layers,this.add(l);let c=new Kt(ms,gs,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===jn)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===xs)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),v=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,1,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,p),e.xr.enabled=v,n.texture.needsPMREMUpdate=!0}},Dl=class extends Kt{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Fu="\\[\\]\\.:\\/",h_=new RegExp("["+Fu+"]","g"),Uu="[^"+Fu+"]",u_="[^"+Fu.replace("\\.","")+"]",f_=/((?:WC+[\/:])*)/.source.replace("WC",Uu),d_=/(WCOD+)?/.source.replace("WCOD",u_),p_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Uu),m_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Uu),g_=new RegExp("^"+f_+d_+p_+m_+"$"),v_=["material","materials","bones","map"],su=class{constructor(e,t,n){let r=n||Pt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Pt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(h_,"")}static parseTrackName(e){let t=g_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);v_.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Je("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Je("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Je("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Je("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Je("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Je("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;Je("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){Je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Je("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Pt.Composite=su;Pt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Pt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Pt.prototype.GetterByBindingType=[Pt.prototype._getValue_direct,Pt.prototype._getValue_array,Pt.prototype._getValue_arrayElement,Pt.prototype._getValue_toArray];Pt.prototype.SetterByBindingTypeAndVersioning=[[Pt.prototype._setValue_direct,Pt.prototype._setValue_direct_setNeedsUpdate,Pt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Pt.prototype._setValue_array,Pt.prototype._setValue_array_setNeedsUpdate,Pt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Pt.prototype._setValue_arrayElement,Pt.prototype._setValue_arrayElement_setNeedsUpdate,Pt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Pt.prototype._setValue_fromArray,Pt.prototype._setValue_fromArray_setNeedsUpdate,Pt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var U1=new Float32Array(1);var ou=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=n,s[3]=r,this}};var Ip=new W,ol,Yh,Vo=class extends Ht{constructor(e=new W(0,0,1),t=new W(0,0,0),n=1,r=16776960,s=n*.2,o=s*.2){super(),this.type="ArrowHelper",ol===void 0&&(ol=new Nt,ol.setAttribute("position",new zt([0,0,0,0,1,0],3)),Yh=new Sl(.5,1,5,1),Yh.translate(0,-.5,0)),this.position.copy(t),this.line=new Mi(ol,new qi({color:r,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new St(Yh,new ai({color:r,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,s,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{Ip.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(Ip,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};function Ou(i,e,t,n){let r=__(n);switch(t){case Su:return i*e;case nr:return i*e/r.components*r.byteLength;case Hl:return i*e/r.components*r.byteLength;case Fn:return i*e*2/r.components*r.byteLength;case Gl:return i*e*2/r.components*r.byteLength;case wu:return i*e*3/r.components*r.byteLength;case xt:return i*e*4/r.components*r.byteLength;case Vl:return i*e*4/r.components*r.byteLength;case qo:case Yo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Zo:case Ko:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case $l:case ql:return Math.max(i,16)*Math.max(e,8)/4;case Wl:case Xl:return Math.max(i,8)*Math.max(e,8)/2;case Yl:case Zl:case Jl:case jl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Kl:case Jo:case Ql:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ec:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case tc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case nc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ic:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case rc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case sc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case oc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ac:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case lc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case cc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case hc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case uc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case fc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case dc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case pc:case mc:case gc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case vc:case _c:return Math.ceil(i/4)*Math.ceil(e/4)*8;case jo:case yc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function __(i){switch(i){case Dn:case yu:return{byteLength:1,components:1};case Bs:case xu:case Jt:return{byteLength:2,components:1};case kl:case zl:return{byteLength:2,components:4};case ci:case Bl:case yt:return{byteLength:4,components:1};case bu:case Mu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function km(){let i=null,e=!1,t=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){i=s}}}function x_(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,v)=>p.start-v.start);let f=0;for(let p=1;p<u.length;p++){let v=u[f],y=u[p];y.start<=v.start+v.count+1?v.count=Math.max(v.count,y.start+y.count-v.start):(++f,u[f]=y)}u.length=f+1;for(let p=0,v=u.length;p<v;p++){let y=u[p];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var b_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,M_=`#ifdef USE_ALPHAHASH
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
#endif`,S_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,w_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,A_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,T_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,E_=`#ifdef USE_AOMAP
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
#endif`,R_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,C_=`#ifdef USE_BATCHING
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
#endif`,I_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,P_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,L_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,N_=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,D_=`#ifdef USE_IRIDESCENCE
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
#endif`,F_=`#ifdef USE_BUMPMAP
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
#endif`,U_=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,O_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,B_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,k_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,z_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,H_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,G_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,V_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,W_=`#define PI 3.141592653589793
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
} // validated`,$_=`vec3 transformedNormal = objectNormal;
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
#endif`,X_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,q_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Y_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Z_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,K_="gl_FragColor = linearToOutputTexel( gl_FragColor );",J_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,j_=`#ifdef USE_ENVMAP
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
#endif`,Q_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ey=`#ifdef USE_ENVMAP
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
#endif`,ty=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ny=`#ifdef USE_ENVMAP
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
#endif`,iy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ry=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,sy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,oy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ay=`#ifdef USE_GRADIENTMAP
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
}`,ly=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,uy=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,fy=`#ifdef USE_ENVMAP
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
#endif`,dy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,py=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,my=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,vy=`PhysicalMaterial material;
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
#endif`,_y=`uniform sampler2D dfgLUT;
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
}`,yy=`
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
#endif`,xy=`#if defined( RE_IndirectDiffuse )
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
#endif`,by=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,My=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Sy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ay=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ty=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ey=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ry=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Iy=`#if defined( USE_POINTS_UV )
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
#endif`,Py=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ly=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ny=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Dy=`#if defined( USE_MORPHCOLORS )
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
#endif`,Fy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Uy=`#ifdef USE_MORPHTARGETS
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
#endif`,Oy=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,By=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ky=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,zy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Hy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Vy=`#ifdef USE_NORMALMAP
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
#endif`,Wy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$y=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Xy=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,qy=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Yy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zy=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Ky=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Jy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,jy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qy=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ex=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,tx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ix=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,rx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,sx=`float getShadowMask() {
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
}`,ox=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ax=`#ifdef USE_SKINNING
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
#endif`,lx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cx=`#ifdef USE_SKINNING
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
#endif`,hx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ux=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,dx=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,px=`#ifdef USE_TRANSMISSION
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
#endif`,mx=`#ifdef USE_TRANSMISSION
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
#endif`,gx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_x=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,yx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,xx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bx=`uniform sampler2D t2D;
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
}`,Mx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Sx=`uniform float backgroundBlurriness;
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
}`,wx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ax=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Tx=`#include <common>
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
}`,Ex=`#if DEPTH_PACKING == 3200
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
}`,Rx=`#define DISTANCE
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
}`,Cx=`#define DISTANCE
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
}`,Ix=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Px=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Lx=`uniform float scale;
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
}`,Nx=`uniform vec3 diffuse;
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
}`,Dx=`#include <common>
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
}`,Fx=`uniform vec3 diffuse;
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
}`,Ux=`#define LAMBERT
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
}`,Ox=`#define LAMBERT
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
}`,Bx=`#define MATCAP
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
}`,kx=`#define MATCAP
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
}`,zx=`#define NORMAL
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
}`,Hx=`#define NORMAL
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
}`,Gx=`#define PHONG
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
}`,Vx=`#define PHONG
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
}`,Wx=`#define STANDARD
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
}`,$x=`#define STANDARD
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
}`,Xx=`#define TOON
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
}`,qx=`#define TOON
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
}`,Yx=`uniform float size;
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
}`,Zx=`uniform vec3 diffuse;
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
}`,Kx=`#include <common>
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
}`,Jx=`uniform vec3 color;
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
}`,jx=`uniform float rotation;
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
}`,Qx=`uniform vec3 diffuse;
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
}`,rt={alphahash_fragment:b_,alphahash_pars_fragment:M_,alphamap_fragment:S_,alphamap_pars_fragment:w_,alphatest_fragment:A_,alphatest_pars_fragment:T_,aomap_fragment:E_,aomap_pars_fragment:R_,batching_pars_vertex:C_,batching_vertex:I_,begin_vertex:P_,beginnormal_vertex:L_,bsdfs:N_,iridescence_fragment:D_,bumpmap_pars_fragment:F_,clipping_planes_fragment:U_,clipping_planes_pars_fragment:O_,clipping_planes_pars_vertex:B_,clipping_planes_vertex:k_,color_fragment:z_,color_pars_fragment:H_,color_pars_vertex:G_,color_vertex:V_,common:W_,defaultnormal_vertex:$_,displacementmap_pars_vertex:X_,displacementmap_vertex:q_,emissivemap_fragment:Y_,emissivemap_pars_fragment:Z_,colorspace_fragment:K_,colorspace_pars_fragment:J_,envmap_fragment:j_,envmap_common_pars_fragment:Q_,envmap_pars_fragment:ey,envmap_pars_vertex:ty,envmap_physical_pars_fragment:fy,envmap_vertex:ny,fog_vertex:iy,fog_pars_vertex:ry,fog_fragment:sy,fog_pars_fragment:oy,gradientmap_pars_fragment:ay,lightmap_pars_fragment:ly,lights_lambert_fragment:cy,lights_lambert_pars_fragment:hy,lights_pars_begin:uy,lights_toon_fragment:dy,lights_toon_pars_fragment:py,lights_phong_fragment:my,lights_phong_pars_fragment:gy,lights_physical_fragment:vy,lights_physical_pars_fragment:_y,lights_fragment_begin:yy,lights_fragment_maps:xy,lights_fragment_end:by,lightprobes_pars_fragment:My,logdepthbuf_fragment:Sy,logdepthbuf_pars_fragment:wy,logdepthbuf_pars_vertex:Ay,logdepthbuf_vertex:Ty,map_fragment:Ey,map_pars_fragment:Ry,map_particle_fragment:Cy,map_particle_pars_fragment:Iy,metalnessmap_fragment:Py,metalnessmap_pars_fragment:Ly,morphinstance_vertex:Ny,morphcolor_vertex:Dy,morphnormal_vertex:Fy,morphtarget_pars_vertex:Uy,morphtarget_vertex:Oy,normal_fragment_begin:By,normal_fragment_maps:ky,normal_pars_fragment:zy,normal_pars_vertex:Hy,normal_vertex:Gy,normalmap_pars_fragment:Vy,clearcoat_normal_fragment_begin:Wy,clearcoat_normal_fragment_maps:$y,clearcoat_pars_fragment:Xy,iridescence_pars_fragment:qy,opaque_fragment:Yy,packing:Zy,premultiplied_alpha_fragment:Ky,project_vertex:Jy,dithering_fragment:jy,dithering_pars_fragment:Qy,roughnessmap_fragment:ex,roughnessmap_pars_fragment:tx,shadowmap_pars_fragment:nx,shadowmap_pars_vertex:ix,shadowmap_vertex:rx,shadowmask_pars_fragment:sx,skinbase_vertex:ox,skinning_pars_vertex:ax,skinning_vertex:lx,skinnormal_vertex:cx,specularmap_fragment:hx,specularmap_pars_fragment:ux,tonemapping_fragment:fx,tonemapping_pars_fragment:dx,transmission_fragment:px,transmission_pars_fragment:mx,uv_pars_fragment:gx,uv_pars_vertex:vx,uv_vertex:_x,worldpos_vertex:yx,background_vert:xx,background_frag:bx,backgroundCube_vert:Mx,backgroundCube_frag:Sx,cube_vert:wx,cube_frag:Ax,depth_vert:Tx,depth_frag:Ex,distance_vert:Rx,distance_frag:Cx,equirect_vert:Ix,equirect_frag:Px,linedashed_vert:Lx,linedashed_frag:Nx,meshbasic_vert:Dx,meshbasic_frag:Fx,meshlambert_vert:Ux,meshlambert_frag:Ox,meshmatcap_vert:Bx,meshmatcap_frag:kx,meshnormal_vert:zx,meshnormal_frag:Hx,meshphong_vert:Gx,meshphong_frag:Vx,meshphysical_vert:Wx,meshphysical_frag:$x,meshtoon_vert:Xx,meshtoon_frag:qx,points_vert:Yx,points_frag:Zx,shadow_vert:Kx,shadow_frag:Jx,sprite_vert:jx,sprite_frag:Qx},Fe={common:{diffuse:{value:new $e(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ke}},envmap:{envMap:{value:null},envMapRotation:{value:new Ke},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ke}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ke}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ke},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ke},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ke},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ke}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ke}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ke}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new $e(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new $e(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0},uvTransform:{value:new Ke}},sprite:{diffuse:{value:new $e(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}}},Ei={basic:{uniforms:vn([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.fog]),vertexShader:rt.meshbasic_vert,fragmentShader:rt.meshbasic_frag},lambert:{uniforms:vn([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new $e(0)},envMapIntensity:{value:1}}]),vertexShader:rt.meshlambert_vert,fragmentShader:rt.meshlambert_frag},phong:{uniforms:vn([Fe.common,Fe.specularmap,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,Fe.lights,{emissive:{value:new $e(0)},specular:{value:new $e(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:rt.meshphong_vert,fragmentShader:rt.meshphong_frag},standard:{uniforms:vn([Fe.common,Fe.envmap,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.roughnessmap,Fe.metalnessmap,Fe.fog,Fe.lights,{emissive:{value:new $e(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:rt.meshphysical_vert,fragmentShader:rt.meshphysical_frag},toon:{uniforms:vn([Fe.common,Fe.aomap,Fe.lightmap,Fe.emissivemap,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.gradientmap,Fe.fog,Fe.lights,{emissive:{value:new $e(0)}}]),vertexShader:rt.meshtoon_vert,fragmentShader:rt.meshtoon_frag},matcap:{uniforms:vn([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,Fe.fog,{matcap:{value:null}}]),vertexShader:rt.meshmatcap_vert,fragmentShader:rt.meshmatcap_frag},points:{uniforms:vn([Fe.points,Fe.fog]),vertexShader:rt.points_vert,fragmentShader:rt.points_frag},dashed:{uniforms:vn([Fe.common,Fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:rt.linedashed_vert,fragmentShader:rt.linedashed_frag},depth:{uniforms:vn([Fe.common,Fe.displacementmap]),vertexShader:rt.depth_vert,fragmentShader:rt.depth_frag},normal:{uniforms:vn([Fe.common,Fe.bumpmap,Fe.normalmap,Fe.displacementmap,{opacity:{value:1}}]),vertexShader:rt.meshnormal_vert,fragmentShader:rt.meshnormal_frag},sprite:{uniforms:vn([Fe.sprite,Fe.fog]),vertexShader:rt.sprite_vert,fragmentShader:rt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ke},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:rt.background_vert,fragmentShader:rt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ke}},vertexShader:rt.backgroundCube_vert,fragmentShader:rt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:rt.cube_vert,fragmentShader:rt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:rt.equirect_vert,fragmentShader:rt.equirect_frag},distance:{uniforms:vn([Fe.common,Fe.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:rt.distance_vert,fragmentShader:rt.distance_frag},shadow:{uniforms:vn([Fe.lights,Fe.fog,{color:{value:new $e(0)},opacity:{value:1}}]),vertexShader:rt.shadow_vert,fragmentShader:rt.shadow_frag}};Ei.physical={uniforms:vn([Ei.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ke},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ke},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ke},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ke},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ke},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ke},sheen:{value:0},sheenColor:{value:new $e(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ke},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ke},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ke},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ke},attenuationDistance:{value:0},attenuationColor:{value:new $e(0)},specularColor:{value:new $e(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ke},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ke},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ke}}]),vertexShader:rt.meshphysical_vert,fragmentShader:rt.meshphysical_frag};var Sc={r:0,b:0,g:0},eb=new et,zm=new Ke;zm.set(-1,0,0,0,1,0,0,0,1);function tb(i,e,t,n,r,s){let o=new $e(0),a=r===!0?0:1,l,c,h=null,u=0,f=null;function p(A){let M=A.isScene===!0?A.background:null;if(M&&M.isTexture){let w=A.backgroundBlurriness>0;M=e.get(M,w)}return M}function v(A){let M=!1,w=p(A);w===null?m(o,a):w&&w.isColor&&(m(w,1),M=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,s):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(A,M){let w=p(M);w&&w.isCubeTexture?(c===void 0&&(c=new St(new Cs(1,1,1),new Ft({name:"BackgroundCubeMaterial",uniforms:Yr(Ei.backgroundCube.uniforms),vertexShader:Ei.backgroundCube.vertexShader,fragmentShader:Ei.backgroundCube.fragmentShader,side:un,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(eb.makeRotationFromEuler(M.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(zm),c.material.toneMapped=st.getTransfer(w.colorSpace)!==bt,(h!==w||u!==w.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,u=w.version,f=i.toneMapping),c.layers.enableAll(),A.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new St(new li(2,2),new Ft({name:"BackgroundMaterial",uniforms:Yr(Ei.background.uniforms),vertexShader:Ei.background.vertexShader,fragmentShader:Ei.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=st.getTransfer(w.colorSpace)!==bt,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||u!==w.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,u=w.version,f=i.toneMapping),l.layers.enableAll(),A.unshift(l,l.geometry,l.material,0,0,null))}function m(A,M){A.getRGB(Sc,Du(i)),t.buffers.color.setClear(Sc.r,Sc.g,Sc.b,M,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(A,M=1){o.set(A),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(A){a=A,m(o,a)},render:v,addToRenderList:y,dispose:g}}function nb(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=f(null),s=r,o=!1;function a(F,B,z,D,$){let q=!1,K=u(F,D,z,B);s!==K&&(s=K,c(s.object)),q=p(F,D,z,$),q&&v(F,D,z,$),$!==null&&e.update($,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,w(F,B,z,D),$!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get($).buffer))}function l(){return i.createVertexArray()}function c(F){return i.bindVertexArray(F)}function h(F){return i.deleteVertexArray(F)}function u(F,B,z,D){let $=D.wireframe===!0,q=n[B.id];q===void 0&&(q={},n[B.id]=q);let K=F.isInstancedMesh===!0?F.id:0,fe=q[K];fe===void 0&&(fe={},q[K]=fe);let J=fe[z.id];J===void 0&&(J={},fe[z.id]=J);let ae=J[$];return ae===void 0&&(ae=f(l()),J[$]=ae),ae}function f(F){let B=[],z=[],D=[];for(let $=0;$<t;$++)B[$]=0,z[$]=0,D[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:z,attributeDivisors:D,object:F,attributes:{},index:null}}function p(F,B,z,D){let $=s.attributes,q=B.attributes,K=0,fe=z.getAttributes();for(let J in fe)if(fe[J].location>=0){let ce=$[J],we=q[J];if(we===void 0&&(J==="instanceMatrix"&&F.instanceMatrix&&(we=F.instanceMatrix),J==="instanceColor"&&F.instanceColor&&(we=F.instanceColor)),ce===void 0||ce.attribute!==we||we&&ce.data!==we.data)return!0;K++}return s.attributesNum!==K||s.index!==D}function v(F,B,z,D){let $={},q=B.attributes,K=0,fe=z.getAttributes();for(let J in fe)if(fe[J].location>=0){let ce=q[J];ce===void 0&&(J==="instanceMatrix"&&F.instanceMatrix&&(ce=F.instanceMatrix),J==="instanceColor"&&F.instanceColor&&(ce=F.instanceColor));let we={};we.attribute=ce,ce&&ce.data&&(we.data=ce.data),$[J]=we,K++}s.attributes=$,s.attributesNum=K,s.index=D}function y(){let F=s.newAttributes;for(let B=0,z=F.length;B<z;B++)F[B]=0}function m(F){g(F,0)}function g(F,B){let z=s.newAttributes,D=s.enabledAttributes,$=s.attributeDivisors;z[F]=1,D[F]===0&&(i.enableVertexAttribArray(F),D[F]=1),$[F]!==B&&(i.vertexAttribDivisor(F,B),$[F]=B)}function A(){let F=s.newAttributes,B=s.enabledAttributes;for(let z=0,D=B.length;z<D;z++)B[z]!==F[z]&&(i.disableVertexAttribArray(z),B[z]=0)}function M(F,B,z,D,$,q,K){K===!0?i.vertexAttribIPointer(F,B,z,$,q):i.vertexAttribPointer(F,B,z,D,$,q)}function w(F,B,z,D){y();let $=D.attributes,q=z.getAttributes(),K=B.defaultAttributeValues;for(let fe in q){let J=q[fe];if(J.location>=0){let ae=$[fe];if(ae===void 0&&(fe==="instanceMatrix"&&F.instanceMatrix&&(ae=F.instanceMatrix),fe==="instanceColor"&&F.instanceColor&&(ae=F.instanceColor)),ae!==void 0){let ce=ae.normalized,we=ae.itemSize,De=e.get(ae);if(De===void 0)continue;let ie=De.buffer,Re=De.type,Ue=De.bytesPerElement,ze=Re===i.INT||Re===i.UNSIGNED_INT||ae.gpuType===Bl;if(ae.isInterleavedBufferAttribute){let me=ae.data,Xe=me.isInterleavedBuffer===!0?me.stride:me.itemSize,wt=ae.offset;if(me.isInstancedInterleavedBuffer||me.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)g(J.location+Ve,me.meshPerAttribute);F.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=me.meshPerAttribute*me.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve);i.bindBuffer(i.ARRAY_BUFFER,ie);for(let Ve=0;Ve<J.locationSize;Ve++)M(J.location+Ve,we/J.locationSize,Re,ce,Xe*Ue,(wt+we/J.locationSize*Ve)*Ue,ze)}else{if(ae.isInstancedBufferAttribute){for(let me=0;me<J.locationSize;me++)g(J.location+me,ae.meshPerAttribute);F.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let me=0;me<J.locationSize;me++)m(J.location+me);i.bindBuffer(i.ARRAY_BUFFER,ie);for(let me=0;me<J.locationSize;me++)M(J.location+me,we/J.locationSize,Re,ce,we*Ue,we/J.locationSize*me*Ue,ze)}}else if(K!==void 0){let ce=K[fe];if(ce!==void 0)switch(ce.length){case 2:i.vertexAttrib2fv(J.location,ce);break;case 3:i.vertexAttrib3fv(J.location,ce);break;case 4:i.vertexAttrib4fv(J.location,ce);break;default:i.vertexAttrib1fv(J.location,ce)}}}}A()}function T(){P();for(let F in n){let B=n[F];for(let z in B){let D=B[z];for(let $ in D){let q=D[$];for(let K in q)h(q[K].object),delete q[K];delete D[$]}}delete n[F]}}function E(F){if(n[F.id]===void 0)return;let B=n[F.id];for(let z in B){let D=B[z];for(let $ in D){let q=D[$];for(let K in q)h(q[K].object),delete q[K];delete D[$]}}delete n[F.id]}function x(F){for(let B in n){let z=n[B];for(let D in z){let $=z[D];if($[F.id]===void 0)continue;let q=$[F.id];for(let K in q)h(q[K].object),delete q[K];delete $[F.id]}}}function b(F){for(let B in n){let z=n[B],D=F.isInstancedMesh===!0?F.id:0,$=z[D];if($!==void 0){for(let q in $){let K=$[q];for(let fe in K)h(K[fe].object),delete K[fe];delete $[q]}delete z[D],Object.keys(z).length===0&&delete n[B]}}}function P(){I(),o=!0,s!==r&&(s=r,c(s.object))}function I(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:P,resetDefaultState:I,dispose:T,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:m,disableUnusedAttributes:A}}function ib(i,e,t){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let p=0;p<h;p++)f+=c[p];t.update(f,n,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function rb(i,e,t,n){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(x){return!(x!==xt&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let b=x===Jt&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==Dn&&x!==yt&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),A=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),T=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:p,maxVertexTextures:v,maxTextureSize:y,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:A,maxVaryings:M,maxFragmentUniforms:w,maxSamples:T,samples:E}}function sb(i){let e=this,t=null,n=0,r=!1,s=!1,o=new oi,a=new Ke,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let p=u.length!==0||f||n!==0||r;return r=f,n=u.length,p},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,p){let v=u.clippingPlanes,y=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!r||v===null||v.length===0||s&&!m)s?h(null):c();else{let A=s?0:n,M=A*4,w=g.clippingState||null;l.value=w,w=h(v,f,M,p);for(let T=0;T!==M;++T)w[T]=t[T];g.clippingState=w,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=A}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,f,p,v){let y=u!==null?u.length:0,m=null;if(y!==0){if(m=l.value,v!==!0||m===null){let g=p+y*4,A=f.matrixWorldInverse;a.getNormalMatrix(A),(m===null||m.length<g)&&(m=new Float32Array(g));for(let M=0,w=p;M!==y;++M,w+=4)o.copy(u[M]).applyMatrix4(A,a),o.normal.toArray(m,w),m[w+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}}var na=class extends tn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new Po(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new Cs(5,5,5),s=new Ft({name:"CubemapFromEquirect",uniforms:Yr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:un,blending:Vr});s.uniforms.tEquirect.value=t;let o=new St(r,s),a=t.minFilter;return t.minFilter===Wn&&(t.minFilter=Rt),new Ls(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,r);e.setRenderTarget(s)}},_m=256,ob=3,ab=20,Hm=256,Gm=16,lb=3,cb=new W,hb=new $e,Ac=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ls(1,10,null),this._boxMesh=new St(new Cs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,s={}){let{size:o=256,position:a=cb}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,v=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(hb));let m=new Ls(n,r,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=v,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=bm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=xm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(_m,Pu(e))}_fromTexture(e,t){e.mapping===$r||e.mapping===Us?this._setSize(e.image.length===0?_m:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=ym(e,!1,!1),n=Math.log2(e)-ob;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=ym(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===$r||e.mapping===Us?(this._cubemapMaterial===null&&(this._cubemapMaterial=bm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=xm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ub(),this._integrationMaterial=fb());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/Gm);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-lb)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Hm*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=db());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(s,0,n)}};function ym(i,e,t){return new na(i,{minFilter:Wn,generateMipmaps:e,type:Jt,colorSpace:Lt,depthBuffer:t})}function ia(i,e,t){return new Ft({name:i,uniforms:e,vertexShader:rt.cube_vert,fragmentShader:t,side:un,blending:Vr,depthTest:!1,depthWrite:!1})}function ub(){return ia("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Hm}u

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
	`)}function fb(){return ia("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Gm}},`

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
	`)}function db(){return ia("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ab}
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
	`)}function xm(){return ia("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function bm(){return ia("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function pb(i){let e=new WeakMap,t=new WeakMap,n=null;function r(f,p=!1){return f==null?null:p?o(f):s(f)}function s(f){if(f&&f.isTexture){let p=f.mapping;if(p===Fl||p===Ul)if(e.has(f)){let v=e.get(f).texture;return a(v,f.mapping)}else{let v=f.image;if(v&&v.height>0){let y=new na(v.height);return y.fromEquirectangularTexture(i,f),e.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,v=p===Fl||p===Ul,y=p===$r||p===Us;if(v||y){let m=t.get(f),g=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return n===null&&(n=new Ac(i)),m=v?n.fromEquirectangular(f,m):n.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),m.texture;if(m!==void 0)return m.texture;{let A=f.image;return v&&A&&A.height>0||y&&A&&l(A)?(n===null&&(n=new Ac(i)),m=v?n.fromEquirectangular(f):n.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,t.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,p){return p===Fl?f.mapping=$r:p===Ul&&(f.mapping=Us),f}function l(f){let p=0,v=6;for(let y=0;y<v;y++)f[y]!==void 0&&p++;return p===v}function c(f){let p=f.target;p.removeEventListener("dispose",c);let v=e.get(p);v!==void 0&&(e.delete(p),v.dispose())}function h(f){let p=f.target;p.removeEventListener("dispose",h);let v=t.get(p);v!==void 0&&(t.delete(p),v.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:u}}function mb(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let r=t(n);return r===null&&Nr("WebGLRenderer: "+n+" extension not supported."),r}}}function gb(i,e,t,n){let r={},s=new WeakMap,o=new FinalizationRegistry(v=>delete r[v]);function a(v){l(v.target)}function l(v){v.index!==null&&e.remove(v.index);for(let m in v.attributes)e.remove(v.attributes[m]);v.removeEventListener("dispose",a),delete r[v.id],o.unregister(v);let y=s.get(v);y&&(e.remove(y),s.delete(v)),n.releaseStatesOfGeometry(v),v.isInstancedBufferGeometry===!0&&delete v._maxInstanceCount,t.memory.geometries--}function c(v,y){return r[y.id]!==void 0||(y.addEventListener("dispose",a),r[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(v){let y=v.attributes;for(let m in y)e.update(y[m],i.ARRAY_BUFFER)}function u(v){let y=v.index,m=v.attributes.position,g=0;if(m===void 0)return;let A=y!==null?y.array.length:m.array.length/3-1,M=m.count>=65535?Br:Or,w=new M(Math.ceil(A/3)*6,1),T=w.array;if(y!==null){let x=y.array;g=y.version;for(let b=0,P=0;b<A;b+=3){let I=x[b+0],F=x[b+1],B=x[b+2];T[P++]=I,T[P++]=F,T[P++]=F,T[P++]=B,T[P++]=B,T[P++]=I}}else{g=m.version;for(let x=0,b=0;x<A;x+=3){let P=x+0,I=x+1,F=x+2;T[b++]=P,T[b++]=I,T[b++]=I,T[b++]=F,T[b++]=F,T[b++]=P}}w.version=g;let E=s.get(v);E&&e.remove(E),s.set(v,w)}function f(v){let y=s.get(v);if(y){let m=v.index;m!==null&&y.version<m.version&&u(v)}else u(v);return s.get(v)}function p(){for(let v in r){let y=r[v].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:f,dispose:p}}function vb(i,e,t){let n;function r(u){n=u}let s,o;function a(u){s=u.type,o=u.bytesPerElement}function l(u,f){i.drawElements(n,f,s,u*o),t.update(f,n,1)}function c(u,f,p){p!==0&&(i.drawElementsInstanced(n,f,s,u*o,p),t.update(f,n,p))}function h(u,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,s,u,0,p);let y=0;for(let m=0;m<p;m++)y+=f[m];t.update(y,n,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function _b(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(s/3);break;case i.LINES:t.lines+=a*(s/2);break;case i.LINE_STRIP:t.lines+=a*(s-1);break;case i.LINE_LOOP:t.lines+=a*s;break;case i.POINTS:t.points+=a*s;break;default:Je("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}function yb(i,e,t){let n=new WeakMap,r=new Tt;function s(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let P=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",P)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],A=a.morphAttributes.color||[],M=0;p===!0&&(M=1),v===!0&&(M=2),y===!0&&(M=3);let w=a.attributes.position.count*M,T=1;w>e.maxTextureSize&&(T=Math.ceil(w/e.maxTextureSize),w=e.maxTextureSize);let E=new Float32Array(w*T*4*u),x=new xo(E,w,T,u);x.type=yt,x.needsUpdate=!0;let b=M*4;for(let I=0;I<u;I++){let F=m[I],B=g[I],z=A[I],D=w*T*4*I;for(let $=0;$<F.count;$++){let q=$*b;p===!0&&(r.fromBufferAttribute(F,$),E[D+q+0]=r.x,E[D+q+1]=r.y,E[D+q+2]=r.z,E[D+q+3]=0),v===!0&&(r.fromBufferAttribute(B,$),E[D+q+4]=r.x,E[D+q+5]=r.y,E[D+q+6]=r.z,E[D+q+7]=0),y===!0&&(r.fromBufferAttribute(z,$),E[D+q+8]=r.x,E[D+q+9]=r.y,E[D+q+10]=r.z,E[D+q+11]=z.itemSize===4?r.w:1)}}f={count:u,texture:x,size:new it(w,T)},n.set(a,f),a.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let y=0;y<c.length;y++)p+=c[y];let v=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",v),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:s}}function xb(i,e,t,n,r){let s=new WeakMap;function o(c){let h=r.render.frame,u=c.geometry,f=e.get(c,u);if(s.get(f)!==h&&(e.update(f),s.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==h&&(p.update(),s.set(p,h))}return f}function a(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var bb={[$o]:"LINEAR_TONE_MAPPING",[pu]:"REINHARD_TONE_MAPPING",[mu]:"CINEON_TONE_MAPPING",[gu]:"ACES_FILMIC_TONE_MAPPING",[Xo]:"AGX_TONE_MAPPING",[Fs]:"NEUTRAL_TONE_MAPPING",[vu]:"CUSTOM_TONE_MAPPING"};function Mb(i,e,t,n,r,s){let o=new tn(e,t,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Nt;h.setAttribute("position",new zt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new zt([0,2,0,0,2,0],2));let u=new wl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new St(h,u),p=new Vn(-1,1,1,-1,0,1),v=null,y=null,m=!1,g,A=null,M=[],w=!1;this.setSize=function(T,E){o.setSize(T,E),a!==null&&a.setSize(T,E),l!==null&&l.setSize(T,E);for(let x=0;x<M.length;x++){let b=M[x];b.setSize&&b.setSize(T,E)}},this.setEffects=function(T){M=T,w=M.length>0&&M[0].isRenderPass===!0;let E=o.width,x=o.height;M.length>0&&a===null&&(a=new tn(E,x,{type:Jt,depthBuffer:!1,stencilBuffer:!1}),l=new tn(E,x,{type:Jt,depthBuffer:!1,stencilBuffer:!1}));let b=r===!0&&M.some(P=>P.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new Yi(E,x),s===!0&&(c.format=tr,c.type=qr)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let P=0;P<M.length;P++){let I=M[P];I.setSize&&I.setSize(E,x),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(T,E){if(m||T.toneMapping===wi&&M.length===0)return!1;if(A=E,E!==null){let x=E.width,b=E.height;(o.width!==x||o.height!==b)&&this.setSize(x,b)}return w===!1&&T.setRenderTarget(o),g=T.toneMapping,T.toneMapping=wi,!0},this.hasRenderPass=function(){return w},this.end=function(T,E){T.toneMapping=g,m=!0;let x=o,b=a;for(let P=0;P<M.length;P++){let I=M[P];I.enabled!==!1&&(I.render(T,b,x,E),I.needsSwap!==!1&&(x=b,b=b===a?l:a))}if(v!==T.outputColorSpace||y!==T.toneMapping){v=T.outputColorSpace,y=T.toneMapping,u.defines={},st.getTransfer(v)===bt&&(u.defines.SRGB_TRANSFER="");let P=bb[y];P&&(u.defines[P]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,T.setRenderTarget(A),T.render(f,p),A=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Vm=new cn,Wm=new Yi(1,1),$m=new Lo(1),Xm=new xo,qm=new _l,Ym=new Po,Mm=[],Sm=[],wm=new Float32Array(16),Am=new Float32Array(9),Tm=new Float32Array(4);function Hs(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,s=Mm[r];if(s===void 0&&(s=new Float32Array(r),Mm[r]=s),e!==0){n.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(s,a)}return s}function rn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ec(i,e){let t=Sm[e];t===void 0&&(t=new Int32Array(e),Sm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Sb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function wb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(rn(t,e))return;i.uniform2fv(this.addr,e),sn(t,e)}}function Ab(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(rn(t,e))return;i.uniform3fv(this.addr,e),sn(t,e)}}function Tb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(rn(t,e))return;i.uniform4fv(this.addr,e),sn(t,e)}}function Eb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(rn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),sn(t,e)}else{if(rn(t,n))return;Tm.set(n),i.uniformMatrix2fv(this.addr,!1,Tm),sn(t,n)}}function Rb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(rn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),sn(t,e)}else{if(rn(t,n))return;Am.set(n),i.uniformMatrix3fv(this.addr,!1,Am),sn(t,n)}}function Cb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(rn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),sn(t,e)}else{if(rn(t,n))return;wm.set(n),i.uniformMatrix4fv(this.addr,!1,wm),sn(t,n)}}function Ib(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Pb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(rn(t,e))return;i.uniform2iv(this.addr,e),sn(t,e)}}function Lb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(rn(t,e))return;i.uniform3iv(this.addr,e),sn(t,e)}}function Nb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(rn(t,e))return;i.uniform4iv(this.addr,e),sn(t,e)}}function Db(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Fb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(rn(t,e))return;i.uniform2uiv(this.addr,e),sn(t,e)}}function Ub(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(rn(t,e))return;i.uniform3uiv(this.addr,e),sn(t,e)}}function Ob(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(rn(t,e))return;i.uniform4uiv(this.addr,e),sn(t,e)}}function Rc(i){return i.version===0&&(i.compareFunction=Ru,i.needsUpdate=!0),i}function Bb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=Rc(Wm):s=Vm,t.setTexture2D(e||s,r)}function kb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||qm,r)}function zb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=Rc($m):s=Ym,t.setTextureCube(e||s,r)}function Hb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||Xm,r)}function Gb(i){switch(i){case 5126:return Sb;case 35664:return wb;case 35665:return Ab;case 35666:return Tb;case 35674:return Eb;case 35675:return Rb;case 35676:return Cb;case 5124:case 35670:return Ib;case 35667:case 35671:return Pb;case 35668:case 35672:return Lb;case 35669:case 35673:return Nb;case 5125:return Db;case 36294:return Fb;case 36295:return Ub;case 36296:return Ob;case 35678:case 36198:case 36298:case 36306:case 35682:return Bb;case 35679:case 36299:case 36307:return kb;case 35680:case 36300:case 36308:case 36293:return zb;case 36289:case 36303:case 36311:case 36292:return Hb}}function Vb(i,e){i.uniform1fv(this.addr,e)}function Wb(i,e){let t=Hs(e,this.size,2);i.uniform2fv(this.addr,t)}function $b(i,e){let t=Hs(e,this.size,3);i.uniform3fv(this.addr,t)}function Xb(i,e){let t=Hs(e,this.size,4);i.uniform4fv(this.addr,t)}function qb(i,e){let t=Hs(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Yb(i,e){let t=Hs(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Zb(i,e){let t=Hs(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Kb(i,e){i.uniform1iv(this.addr,e)}function Jb(i,e){i.uniform2iv(this.addr,e)}function jb(i,e){i.uniform3iv(this.addr,e)}function Qb(i,e){i.uniform4iv(this.addr,e)}function eM(i,e){i.uniform1uiv(this.addr,e)}function tM(i,e){i.uniform2uiv(this.addr,e)}function nM(i,e){i.uniform3uiv(this.addr,e)}function iM(i,e){i.uniform4uiv(this.addr,e)}function rM(i,e,t){let n=this.cache,r=e.length,s=Ec(t,r);rn(n,s)||(i.uniform1iv(this.addr,s),sn(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=Rc(Wm):o=Vm;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function sM(i,e,t){let n=this.cache,r=e.length,s=Ec(t,r);rn(n,s)||(i.uniform1iv(this.addr,s),sn(n,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||qm,s[o])}function oM(i,e,t){let n=this.cache,r=e.length,s=Ec(t,r);rn(n,s)||(i.uniform1iv(this.addr,s),sn(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Rc($m):o=Ym;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function aM(i,e,t){let n=this.cache,r=e.length,s=Ec(t,r);rn(n,s)||(i.uniform1iv(this.addr,s),sn(n,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||Xm,s[o])}function lM(i){switch(i){case 5126:return Vb;case 35664:return Wb;case 35665:return $b;case 35666:return Xb;case 35674:return qb;case 35675:return Yb;case 35676:return Zb;case 5124:case 35670:return Kb;case 35667:case 35671:return Jb;case 35668:case 35672:return jb;case 35669:case 35673:return Qb;case 5125:return eM;case 36294:return tM;case 36295:return nM;case 36296:return iM;case 35678:case 36198:case 36298:case 36306:case 35682:return rM;case 35679:case 36299:case 36307:return sM;case 35680:case 36300:case 36308:case 36293:return oM;case 36289:case 36303:case 36311:case 36292:return aM}}var zu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Gb(t.type)}},Hu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=lM(t.type)}},Gu=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],n)}}},Bu=/(\w+)(\])?(\[|\.)?/g;function Em(i,e){i.seq.push(e),i.map[e.id]=e}function cM(i,e,t){let n=i.name,r=n.length;for(Bu.lastIndex=0;;){let s=Bu.exec(n),o=Bu.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){Em(t,c===void 0?new zu(a,i,e):new Hu(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Gu(a),Em(t,u)),t=u}}}var zs=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);cM(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,n,r){let s=this.map[t];s!==void 0&&s.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&n.push(o)}return n}};function Rm(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var hM=37297,uM=0;function fM(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Cm=new Ke;function dM(i){st._getMatrix(Cm,st.workingColorSpace,i);let e=`mat3( ${Cm.elements.map(t=>t.toFixed(4))} )`;switch(st.getTransfer(i)){case _o:return[e,"LinearTransferOETF"];case bt:return[e,"sRGBTransferOETF"];default:return ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Im(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=(i.getShaderInfoLog(e)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+fM(i.getShaderSource(e),a)}else return s}function pM(i,e){let t=dM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mM={[$o]:"Linear",[pu]:"Reinhard",[mu]:"Cineon",[gu]:"ACESFilmic",[Xo]:"AgX",[Fs]:"Neutral",[vu]:"Custom"};function gM(i,e){let t=mM[e];return t===void 0?(ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var wc=new W;function vM(){st.getLuminanceCoefficients(wc);let i=wc.x.toFixed(4),e=wc.y.toFixed(4),t=wc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function _M(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ta).join(`
`)}function yM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function xM(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(e,r),o=s.name,a=1;s.type===i.FLOAT_MAT2&&(a=2),s.type===i.FLOAT_MAT3&&(a=3),s.type===i.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function ta(i){return i!==""}function Pm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Lm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var bM=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vu(i){return i.replace(bM,MM)}function MM(i,e){let t=rt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Vu(t)}var SM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Nm(i){return i.replace(SM,wM)}function wM(i,e,t,n){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Dm(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var AM={[Wo]:"SHADOWMAP_TYPE_PCF",[Ns]:"SHADOWMAP_TYPE_VSM"};function TM(i){return AM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var EM={[Us]:"ENVMAP_MODE_REFRACTION"};function RM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":EM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var CM={[du]:"ENVMAP_BLENDING_MULTIPLY",[jp]:"ENVMAP_BLENDING_MIX",[Qp]:"ENVMAP_BLENDING_ADD"};function IM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":CM[i.combine]||"ENVMAP_BLENDING_NONE"}function PM(i,e,t,n){let r=i.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=TM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=RM(t),u=IM(t),f=_M(t),p=yM(s),v=r.createProgram(),y,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ta).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(ta).join(`
`),m.length>0&&(m+=`
`)):(y=[Dm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ta).join(`
`),m=[Dm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==wi?"#define TONE_MAPPING":"",t.toneMapping!==wi?rt.tonemapping_pars_fragment:"",t.toneMapping!==wi?gM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",rt.colorspace_pars_fragment,pM("linearToOutputTexel",t.outputColorSpace),vM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ta).join(`
`)),o=Vu(o),o=Pm(o,t),o=Lm(o,t),a=Vu(a),a=Pm(a,t),a=Lm(a,t),o=Nm(o),a=Nm(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",t.glslVersion===nn?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===nn?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let A=g+y+o,M=g+m+a,w=Rm(r,r.VERTEX_SHADER,A),T=Rm(r,r.FRAGMENT_SHADER,M);r.attachShader(v,w),r.attachShader(v,T),t.index0AttributeName!==void 0?r.bindAttribLocation(v,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(v,0,"position"),r.linkProgram(v);function E(I){if(i.debug.checkShaderErrors){let F=r.getProgramInfoLog(v)||"",B=r.getShaderInfoLog(w)||"",z=r.getShaderInfoLog(T)||"",D=F.trim(),$=B.trim(),q=z.trim(),K=!0,fe=!0;if(r.getProgramParameter(v,r.LINK_STATUS)===!1)if(K=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,v,w,T);else{let J=Im(r,w,"vertex"),ae=Im(r,T,"fragment");Je("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(v,r.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+D+`
`+J+`
`+ae)}else D!==""?ke("WebGLProgram: Program Info Log:",D):($===""||q==="")&&(fe=!1);fe&&(I.diagnostics={runnable:K,programLog:D,vertexShader:{log:$,prefix:y},fragmentShader:{log:q,prefix:m}})}r.deleteShader(w),r.deleteShader(T),x=new zs(r,v),b=xM(r,v)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let P=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return P===!1&&(P=r.getProgramParameter(v,hM)),P},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=uM++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=w,this.fragmentShader=T,this}var LM=0,Wu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new $u(e),t.set(e,n)),n}},$u=class{constructor(e){this.id=LM++,this.code=e,this.usedTimes=0}};function NM(i){return i===Fn||i===Jo||i===jo}function DM(i,e,t,n,r,s){let o=new bo,a=new Wu,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function v(x,b,P,I,F,B){let z=I.fog,D=F.geometry,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,K=e.get(x.envMap||$,q),fe=f[x.type],J=n.precision;x.precision!==null&&(J=n.getMaxPrecision(x.precision),J!==x.precision&&ke("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let ae=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ce=ae!==void 0?ae.length:0,we=0;D.morphAttributes.position!==void 0&&(we=1),D.morphAttributes.normal!==void 0&&(we=2),D.morphAttributes.color!==void 0&&(we=3);let De,ie,Re,Ue;if(fe){let Le=Ei[fe];De=Le.vertexShader,ie=Le.fragmentShader}else{De=x.vertexShader,ie=x.fragmentShader;let Le=a.getVertexShaderStage(x),vt=a.getFragmentShaderStage(x);a.update(x,Le,vt),Re=Le.id,Ue=vt.id}let ze=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),Xe=F.isInstancedMesh===!0,wt=F.isBatchedMesh===!0,Ve=!!x.map,ft=!!x.matcap,mt=!!K,at=mt&&K.isPMREMTexture===!0,Vt=!!x.aoMap,kt=!!x.lightMap,on=!!x.bumpMap&&x.wireframe===!1,Ut=!!x.normalMap,Xn=!!x.displacementMap,qt=!!x.emissiveMap,_n=!!x.metalnessMap,yn=!!x.roughnessMap,An=x.anisotropy>0,V=x.clearcoat>0,xn=x.diffuseRoughness>0,Ct=x.dispersion>0,It=x.retroreflectivity>0,Ce=x.iridescence>0,Yt=x.sheen>0,Ge=x.transmission>0,je=An&&!!x.anisotropyMap,O=V&&!!x.clearcoatMap,R=V&&!!x.clearcoatNormalMap,Z=V&&!!x.clearcoatRoughnessMap,ge=xn&&!!x.diffuseRoughnessMap,le=Ce&&!!x.iridescenceMap,be=Ce&&!!x.iridescenceThicknessMap,Ie=Yt&&!!x.sheenColorMap,te=Yt&&!!x.sheenRoughnessMap,re=!!x.specularMap,Me=!!x.specularColorMap,k=!!x.specularIntensityMap,ne=Ge&&!!x.transmissionMap,j=Ge&&!!x.thicknessMap,Ae=!!x.gradientMap,ve=!!x.alphaMap,Se=x.alphaTest>0,Be=!!x.alphaHash,tt=!!x.extensions,_e=wi;x.toneMapped&&(ze===null||ze.isXRRenderTarget===!0)&&(_e=i.toneMapping);let He=at?K.isCompressedCubeTexture?K.image[0].mipmaps:K.mipmaps:null,Qe={shaderID:fe,shaderType:x.type,shaderName:x.name,vertexShader:De,fragmentShader:ie,defines:x.defines,customVertexShaderID:Re,customFragmentShaderID:Ue,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:wt,batchingColor:wt&&F._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&F.instanceColor!==null,instancingMorph:Xe&&F.morphTexture!==null,outputColorSpace:ze===null?i.outputColorSpace:ze.isXRRenderTarget===!0?ze.texture.colorSpace:st.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ve,matcap:ft,envMap:mt,envMapMode:mt&&K.mapping,envMapPMREM:at,envMapMaxLod:at?He.length-1:null,envMapSize:at?He[0].width:null,aoMap:Vt,lightMap:kt,bumpMap:on,normalMap:Ut,displacementMap:Xn,emissiveMap:qt,normalMapObjectSpace:Ut&&x.normalMapType===im,normalMapTangentSpace:Ut&&x.normalMapType===xc,packedNormalMap:Ut&&x.normalMapType===xc&&NM(x.normalMap.format),metalnessMap:_n,roughnessMap:yn,anisotropy:An,anisotropyMap:je,clearcoat:V,clearcoatMap:O,clearcoatNormalMap:R,clearcoatRoughnessMap:Z,diffuseRoughness:xn,diffuseRoughnessMap:ge,dispersion:Ct,retroreflection:It,iridescence:Ce,iridescenceMap:le,iridescenceThicknessMap:be,sheen:Yt,sheenColorMap:Ie,sheenRoughnessMap:te,specularMap:re,specularColorMap:Me,specularIntensityMap:k,transmission:Ge,transmissionMap:ne,thicknessMap:j,gradientMap:Ae,opaque:x.transparent===!1&&x.blending===Ds&&x.alphaToCoverage===!1,alphaMap:ve,alphaTest:Se,alphaHash:Be,combine:x.combine,mapUv:Ve&&p(x.map.channel),aoMapUv:Vt&&p(x.aoMap.channel),lightMapUv:kt&&p(x.lightMap.channel),bumpMapUv:on&&p(x.bumpMap.channel),normalMapUv:Ut&&p(x.normalMap.channel),displacementMapUv:Xn&&p(x.displacementMap.channel),emissiveMapUv:qt&&p(x.emissiveMap.channel),metalnessMapUv:_n&&p(x.metalnessMap.channel),roughnessMapUv:yn&&p(x.roughnessMap.channel),anisotropyMapUv:je&&p(x.anisotropyMap.channel),clearcoatMapUv:O&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:R&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ge&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:le&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:be&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:Ie&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(x.sheenRoughnessMap.channel),specularMapUv:re&&p(x.specularMap.channel),specularColorMapUv:Me&&p(x.specularColorMap.channel),specularIntensityMapUv:k&&p(x.specularIntensityMap.channel),transmissionMapUv:ne&&p(x.transmissionMap.channel),thicknessMapUv:j&&p(x.thicknessMap.channel),alphaMapUv:ve&&p(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ut||An),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:F.isPoints===!0&&!!D.attributes.uv&&(Ve||ve),fog:!!z,useFog:x.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&Ut===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:me,skinning:F.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ce,morphTextureStride:we,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(Le=>Le.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&P.length>0,shadowMapType:i.shadowMap.type,toneMapping:_e,decodeVideoTexture:Ve&&x.map.isVideoTexture===!0&&st.getTransfer(x.map.colorSpace)===bt,decodeVideoTextureEmissive:qt&&x.emissiveMap.isVideoTexture===!0&&st.getTransfer(x.emissiveMap.colorSpace)===bt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Nn,flipSided:x.side===un,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:tt&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&x.extensions.multiDraw===!0||wt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let P in x.defines)b.push(P),b.push(x.defines[P]);return x.isRawShaderMaterial===!1&&(m(b,x),g(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function m(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function g(x,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function A(x){let b=f[x.type],P;if(b){let I=Ei[b];P=mm.clone(I.uniforms)}else P=x.uniforms;return P}function M(x,b){let P=h.get(b);return P!==void 0?++P.usedTimes:(P=new PM(i,b,x,r),c.push(P),h.set(b,P)),P}function w(x){if(--x.usedTimes===0){let b=c.indexOf(x);c[b]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function T(x){a.remove(x)}function E(){a.dispose()}return{getParameters:v,getProgramCacheKey:y,getUniforms:A,acquireProgram:M,releaseProgram:w,releaseShaderCache:T,programs:c,dispose:E}}function FM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function r(o,a,l){i.get(o)[a]=l}function s(){i=new WeakMap}return{has:e,get:t,remove:n,update:r,dispose:s}}function UM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Fm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Um(){let i=[],e=0,t=[],n=[],r=[];function s(){e=0,t.length=0,n.length=0,r.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,v,y,m,g){let A=i[e];return A===void 0?(A={id:f.id,object:f,geometry:p,material:v,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:m,group:g},i[e]=A):(A.id=f.id,A.object=f,A.geometry=p,A.material=v,A.materialVariant=o(f),A.groupOrder=y,A.renderOrder=f.renderOrder,A.z=m,A.group=g),e++,A}function l(f,p,v,y,m,g,A){A.reversedDepth===!0&&(m=-m);let M=a(f,p,v,y,m,g);v.transmission>0?n.push(M):v.transparent===!0?r.push(M):t.push(M)}function c(f,p,v,y,m,g){let A=a(f,p,v,y,m,g);v.transmission>0?n.unshift(A):v.transparent===!0?r.unshift(A):t.unshift(A)}function h(f,p){t.length>1&&t.sort(f||UM),n.length>1&&n.sort(p||Fm),r.length>1&&r.sort(p||Fm)}function u(){for(let f=e,p=i.length;f<p;f++){let v=i[f];if(v.id===null)break;v.id=null,v.object=null,v.geometry=null,v.material=null,v.group=null}}return{opaque:t,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:u,sort:h}}function OM(){let i=new WeakMap;function e(n,r){let s=i.get(n),o;return s===void 0?(o=new Um,i.set(n,[o])):r>=s.length?(o=new Um,s.push(o)):o=s[r],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function BM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new $e};break;case"SpotLight":t={position:new W,direction:new W,color:new $e,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new $e,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new $e,groundColor:new $e};break;case"RectAreaLight":t={color:new $e,position:new W,halfWidth:new W,halfHeight:new W};break}return i[e.id]=t,t}}}function kM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var zM=0;function HM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function GM(i){let e=new BM,t=kM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new W);let r=new W,s=new et,o=new et;function a(c){let h=0,u=0,f=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let p=0,v=0,y=0,m=0,g=0,A=0,M=0,w=0,T=0,E=0,x=0,b=0,P=0,I=0;c.sort(HM);for(let B=0,z=c.length;B<z;B++){let D=c[B],$=D.color,q=D.intensity,K=D.distance,fe=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Fn?fe=D.shadow.map.texture:fe=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=$.r*q,u+=$.g*q,f+=$.b*q;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],q);I++}else if(D.isSunLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let ae=D.shadow,ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize.copy(ae.mapSize).multiply(ae.getFrameExtents()),n.sunShadow[v]=ce,n.sunShadowMap[v]=fe;let we=ae.getViewportCount();for(let De=0;De<we;De++)n.sunShadowMatrix[y+De]=ae.getMatrix(De),n.sunShadowCascade[y+De]=ae._cascadeData[De];y+=we,v++}n.sun[p]=J,p++}else if(D.isDirectionalLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let ae=D.shadow,ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize=ae.mapSize,n.directionalShadow[m]=ce,n.directionalShadowMap[m]=fe,n.directionalShadowMatrix[m]=D.shadow.matrix,T++}n.directional[m]=J,m++}else if(D.isSpotLight){let J=e.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy($).multiplyScalar(q),J.distance=K,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[A]=J;let ae=D.shadow;if(D.map&&(n.spotLightMap[b]=D.map,b++,ae.updateMatrices(D),D.castShadow&&P++),n.spotLightMatrix[A]=ae.matrix,D.castShadow){let ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize=ae.mapSize,n.spotShadow[A]=ce,n.spotShadowMap[A]=fe,x++}A++}else if(D.isRectAreaLight){let J=e.get(D);J.color.copy($).multiplyScalar(q),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[M]=J,M++}else if(D.isPointLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let ae=D.shadow,ce=t.get(D);ce.shadowIntensity=ae.intensity,ce.shadowBias=ae.bias,ce.shadowNormalBias=ae.normalBias,ce.shadowRadius=ae.radius,ce.shadowMapSize=ae.mapSize,ce.shadowCameraNear=ae.camera.near,ce.shadowCameraFar=ae.camera.far,n.pointShadow[g]=ce,n.pointShadowMap[g]=fe,n.pointShadowMatrix[g]=D.shadow.matrix,E++}n.point[g]=J,g++}else if(D.isHemisphereLight){let J=e.get(D);J.skyColor.copy(D.color).multiplyScalar(q),J.groundColor.copy(D.groundColor).multiplyScalar(q),n.hemi[w]=J,w++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Fe.LTC_FLOAT_1,n.rectAreaLTC2=Fe.LTC_FLOAT_2):(n.rectAreaLTC1=Fe.LTC_HALF_1,n.rectAreaLTC2=Fe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let F=n.hash;(F.sunLength!==p||F.directionalLength!==m||F.pointLength!==g||F.spotLength!==A||F.rectAreaLength!==M||F.hemiLength!==w||F.numSunShadows!==v||F.numDirectionalShadows!==T||F.numPointShadows!==E||F.numSpotShadows!==x||F.numSpotMaps!==b||F.numLightProbes!==I)&&(n.sun.length=p,n.directional.length=m,n.spot.length=A,n.rectArea.length=M,n.point.length=g,n.hemi.length=w,n.sunShadow.length=v,n.sunShadowMap.length=v,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=T,n.directionalShadowMap.length=T,n.directionalShadowMatrix.length=T,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-P,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=P,n.numLightProbes=I,F.sunLength=p,F.directionalLength=m,F.pointLength=g,F.spotLength=A,F.rectAreaLength=M,F.hemiLength=w,F.numSunShadows=v,F.numDirectionalShadows=T,F.numPointShadows=E,F.numSpotShadows=x,F.numSpotMaps=b,F.numLightProbes=I,n.version=zM++)}function l(c,h){let u=0,f=0,p=0,v=0,y=0,m=0,g=h.matrixWorldInverse;for(let A=0,M=c.length;A<M;A++){let w=c[A];if(w.isSunLight){let T=n.sun[u];T.direction.setFromMatrixPosition(w.matrixWorld),T.direction.transformDirection(g),u++}else if(w.isDirectionalLight){let T=n.directional[f];T.direction.setFromMatrixPosition(w.matrixWorld),r.setFromMatrixPosition(w.target.matrixWorld),T.direction.sub(r),T.direction.transformDirection(g),f++}else if(w.isSpotLight){let T=n.spot[v];T.position.setFromMatrixPosition(w.matrixWorld),T.position.applyMatrix4(g),T.direction.setFromMatrixPosition(w.matrixWorld),r.setFromMatrixPosition(w.target.matrixWorld),T.direction.sub(r),T.direction.transformDirection(g),v++}else if(w.isRectAreaLight){let T=n.rectArea[y];T.position.setFromMatrixPosition(w.matrixWorld),T.position.applyMatrix4(g),o.identity(),s.copy(w.matrixWorld),s.premultiply(g),o.extractRotation(s),T.halfWidth.set(w.width*.5,0,0),T.halfHeight.set(0,w.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),y++}else if(w.isPointLight){let T=n.point[p];T.position.setFromMatrixPosition(w.matrixWorld),T.position.applyMatrix4(g),p++}else if(w.isHemisphereLight){let T=n.hemi[m];T.direction.setFromMatrixPosition(w.matrixWorld),T.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function Om(i){let e=new GM(i),t=[],n=[],r=[];function s(u){h.camera=u,t.length=0,n.length=0,r.length=0}function o(u){u.isLightProbeGrid?r.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),r.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function VM(i){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new Om(i),e.set(r,[a])):s>=o.length?(a=new Om(i),o.push(a)):a=o[s],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var WM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$M=`uniform sampler2D shadow_pass;
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
}`,XM=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],qM=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],Bm=new et,ea=new W,ku=new W;function YM(i,e,t){let n=new xr,r=new it,s=new it,o=new Tt,a=new Al,l=new Tl,c={},h=t.maxTextureSize,u={[Qn]:un,[un]:Qn,[Nn]:Nn},f=new Ft({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:WM,fragmentShader:$M}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let v=new Nt;v.setAttribute("position",new ht(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new St(v,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Wo;let g=this.type;this.render=function(E,x,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Np&&(ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Wo);let P=i.getRenderTarget(),I=i.getActiveCubeFace(),F=i.getActiveMipmapLevel(),B=i.state;B.setBlending(Vr),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let z=g!==this.type;z&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach($=>$.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,$=E.length;D<$;D++){let q=E[D],K=q.shadow;if(K===void 0){ke("WebGLShadowMap:",q,"has no shadow.");continue}if(K.autoUpdate===!1&&K.needsUpdate===!1)continue;r.copy(K.mapSize);let fe=K.getFrameExtents();r.multiply(fe),s.copy(K.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/fe.x),r.x=s.x*fe.x,K.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/fe.y),r.y=s.y*fe.y,K.mapSize.y=s.y));let J=i.state.buffers.depth.getReversed();if(K.camera._reversedDepth=J,K.map===null||z===!0){if(K.map!==null&&(K.map.depthTexture!==null&&(K.map.depthTexture.dispose(),K.map.depthTexture=null),K.map.dispose()),this.type===Ns){if(q.isPointLight){ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}K.map=new tn(r.x,r.y,{format:Fn,type:Jt,minFilter:Rt,magFilter:Rt,generateMipmaps:!1}),K.map.texture.name=q.name+".shadowMap",K.map.depthTexture=new Yi(r.x,r.y,yt),K.map.depthTexture.name=q.name+".shadowMapDepth",K.map.depthTexture.format=Wi,K.map.depthTexture.compareFunction=null,K.map.depthTexture.minFilter=Mt,K.map.depthTexture.magFilter=Mt}else q.isPointLight?(K.map=new na(r.x),K.map.depthTexture=new Lo(r.x,ci)):(K.map=new tn(r.x,r.y),K.map.depthTexture=new Yi(r.x,r.y,ci)),K.map.depthTexture.name=q.name+".shadowMap",K.map.depthTexture.format=Wi,this.type===Wo?(K.map.depthTexture.compareFunction=J?Eu:Tu,K.map.depthTexture.minFilter=Rt,K.map.depthTexture.magFilter=Rt):(K.map.depthTexture.compareFunction=null,K.map.depthTexture.minFilter=Mt,K.map.depthTexture.magFilter=Mt);K.camera.updateProjectionMatrix()}K.map.isWebGLCubeRenderTarget!==!0&&(K.map.width!==r.x||K.map.height!==r.y)&&K.map.setSize(r.x,r.y);let ae=K.map.isWebGLCubeRenderTarget?6:K.getViewportCount();q.isPointLight!==!0&&K.updateMatrices(q,b);let ce=(K.camera.layers.mask&4294967294)!==0?K.camera.layers:b.layers;for(let we=0;we<ae;we++){let De=K.getCamera(we);if(q.isPointLight){let ie=K.camera,Re=K.matrix,Ue=q.distance||ie.far;Ue!==ie.far&&(ie.far=Ue,ie.updateProjectionMatrix()),ea.setFromMatrixPosition(q.matrixWorld),ie.position.copy(ea),ku.copy(ie.position),ku.add(XM[we]),ie.up.copy(qM[we]),ie.lookAt(ku),ie.updateMatrixWorld(),Re.makeTranslation(-ea.x,-ea.y,-ea.z),Bm.multiplyMatrices(ie.projectionMatrix,ie.matrixWorldInverse),K._frustum.setFromProjectionMatrix(Bm,ie.coordinateSystem,ie.reversedDepth)}if(K.map.isWebGLCubeRenderTarget)i.setRenderTarget(K.map,we),i.clear();else{we===0&&(i.setRenderTarget(K.map),i.clear());let ie=K.getViewport(we);o.set(s.x*ie.x,s.y*ie.y,s.x*ie.z,s.y*ie.w),B.viewport(o)}n=K.getFrustum(we),w(x,b,De,q,ce,this.type)}K.isPointLightShadow!==!0&&this.type===Ns&&A(K,b),K.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(P,I,F)};function A(E,x){let b=e.update(y);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,p.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),E.mapPass===null?E.mapPass=new tn(r.x,r.y,{format:Fn,type:Jt}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),f.uniforms.shadow_pass.value=E.map.depthTexture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,f,y,null),p.uniforms.shadow_pass.value=E.mapPass.texture,p.uniforms.resolution.value.set(E.map.width,E.map.height),p.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,p,y,null)}function M(E,x,b,P){let I=null,F=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(F!==void 0)I=F;else if(I=b.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=I.uuid,z=x.uuid,D=c[B];D===void 0&&(D={},c[B]=D);let $=D[z];$===void 0&&($=I.clone(),D[z]=$,x.addEventListener("dispose",T)),I=$}if(I.visible=x.visible,I.wireframe=x.wireframe,P===Ns?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:u[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=i.properties.get(I);B.light=b}return I}function w(E,x,b,P,I,F){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&F===Ns)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let D=e.update(E),$=E.material;if(Array.isArray($)){let q=D.groups;for(let K=0,fe=q.length;K<fe;K++){let J=q[K],ae=$[J.materialIndex];if(ae&&ae.visible){let ce=M(E,ae,P,F);E.onBeforeShadow(i,E,x,b,D,ce,J),i.renderBufferDirect(b,null,D,ce,E,J),E.onAfterShadow(i,E,x,b,D,ce,J)}}}else if($.visible){let q=M(E,$,P,F);E.onBeforeShadow(i,E,x,b,D,q,null),i.renderBufferDirect(b,null,D,q,E,null),E.onAfterShadow(i,E,x,b,D,q,null)}}let z=E.children;for(let D=0,$=z.length;D<$;D++)w(z[D],x,b,P,I,F)}function T(E){E.target.removeEventListener("dispose",T);for(let b in c){let P=c[b],I=E.target.uuid;I in P&&(P[I].dispose(),delete P[I])}}}function ZM(i,e){function t(){let k=!1,ne=new Tt,j=null,Ae=new Tt(0,0,0,0);return{setMask:function(ve){j!==ve&&!k&&(i.colorMask(ve,ve,ve,ve),j=ve)},setLocked:function(ve){k=ve},setClear:function(ve,Se,Be,tt,_e){_e===!0&&(ve*=tt,Se*=tt,Be*=tt),ne.set(ve,Se,Be,tt),Ae.equals(ne)===!1&&(i.clearColor(ve,Se,Be,tt),Ae.copy(ne))},reset:function(){k=!1,j=null,Ae.set(-1,0,0,0)}}}function n(){let k=!1,ne=!1,j=null,Ae=null,ve=null;return{setReversed:function(Se){if(ne!==Se){let Be=e.get("EXT_clip_control");Se?Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.ZERO_TO_ONE_EXT):Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.NEGATIVE_ONE_TO_ONE_EXT),ne=Se;let tt=ve;ve=null,this.setClear(tt)}},getReversed:function(){return ne},setTest:function(Se){Se?me(i.DEPTH_TEST):Xe(i.DEPTH_TEST)},setMask:function(Se){j!==Se&&!k&&(i.depthMask(Se),j=Se)},setFunc:function(Se){if(ne&&(Se=dm[Se]),Ae!==Se){switch(Se){case cl:i.depthFunc(i.NEVER);break;case hl:i.depthFunc(i.ALWAYS);break;case ul:i.depthFunc(i.LESS);break;case _s:i.depthFunc(i.LEQUAL);break;case fl:i.depthFunc(i.EQUAL);break;case dl:i.depthFunc(i.GEQUAL);break;case pl:i.depthFunc(i.GREATER);break;case ml:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ae=Se}},setLocked:function(Se){k=Se},setClear:function(Se){ve!==Se&&(ve=Se,ne&&(Se=1-Se),i.clearDepth(Se))},reset:function(){k=!1,j=null,Ae=null,ve=null,ne=!1}}}function r(){let k=!1,ne=null,j=null,Ae=null,ve=null,Se=null,Be=null,tt=null,_e=null;return{setTest:function(He){k||(He?me(i.STENCIL_TEST):Xe(i.STENCIL_TEST))},setMask:function(He){ne!==He&&!k&&(i.stencilMask(He),ne=He)},setFunc:function(He,Qe,Le){(j!==He||Ae!==Qe||ve!==Le)&&(i.stencilFunc(He,Qe,Le),j=He,Ae=Qe,ve=Le)},setOp:function(He,Qe,Le){(Se!==He||Be!==Qe||tt!==Le)&&(i.stencilOp(He,Qe,Le),Se=He,Be=Qe,tt=Le)},setLocked:function(He){k=He},setClear:function(He){_e!==He&&(i.clearStencil(He),_e=He)},reset:function(){k=!1,ne=null,j=null,Ae=null,ve=null,Se=null,Be=null,tt=null,_e=null}}}let s=new t,o=new n,a=new r,l={},c=new WeakMap,h={},u={},f={},p=new WeakMap,v=[],y=null,m=!1,g=null,A=null,M=null,w=null,T=null,E=null,x=null,b=new $e(0,0,0),P=0,I=!1,F=null,B=null,z=null,D=null,$=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),K=!1,fe=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(fe=parseFloat(/^WebGL (\d)/.exec(J)[1]),K=fe>=1):J.indexOf("OpenGL ES")!==-1&&(fe=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),K=fe>=2);let ae=null,ce={},we=i.getParameter(i.SCISSOR_BOX),De=i.getParameter(i.VIEWPORT),ie=new Tt().fromArray(we),Re=new Tt().fromArray(De);function Ue(k,ne,j,Ae){let ve=new Uint8Array(4),Se=i.createTexture();i.bindTexture(k,Se),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Be=0;Be<j;Be++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(ne,0,i.RGBA,1,1,Ae,0,i.RGBA,i.UNSIGNED_BYTE,ve):i.texImage2D(ne+Be,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ve);return Se}let ze={};ze[i.TEXTURE_2D]=Ue(i.TEXTURE_2D,i.TEXTURE_2D,1),ze[i.TEXTURE_CUBE_MAP]=Ue(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ze[i.TEXTURE_2D_ARRAY]=Ue(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ze[i.TEXTURE_3D]=Ue(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),me(i.DEPTH_TEST),o.setFunc(_s),on(!1),Ut(au),me(i.CULL_FACE),Vt(Vr);function me(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function Xe(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function wt(k,ne){return f[k]!==ne?(i.bindFramebuffer(k,ne),f[k]=ne,k===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ne),k===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ne),!0):!1}function Ve(k,ne){let j=v,Ae=!1;if(k){j=p.get(ne),j===void 0&&(j=[],p.set(ne,j));let ve=k.textures;if(j.length!==ve.length||j[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,Be=ve.length;Se<Be;Se++)j[Se]=i.COLOR_ATTACHMENT0+Se;j.length=ve.length,Ae=!0}}else j[0]!==i.BACK&&(j[0]=i.BACK,Ae=!0);Ae&&i.drawBuffers(j)}function ft(k){return y!==k?(i.useProgram(k),y=k,!0):!1}let mt={[Wr]:i.FUNC_ADD,[Fp]:i.FUNC_SUBTRACT,[Up]:i.FUNC_REVERSE_SUBTRACT};mt[Op]=i.MIN,mt[Bp]=i.MAX;let at={[kp]:i.ZERO,[zp]:i.ONE,[Hp]:i.SRC_COLOR,[uu]:i.SRC_ALPHA,[qp]:i.SRC_ALPHA_SATURATE,[$p]:i.DST_COLOR,[Vp]:i.DST_ALPHA,[Gp]:i.ONE_MINUS_SRC_COLOR,[fu]:i.ONE_MINUS_SRC_ALPHA,[Xp]:i.ONE_MINUS_DST_COLOR,[Wp]:i.ONE_MINUS_DST_ALPHA,[Yp]:i.CONSTANT_COLOR,[Zp]:i.ONE_MINUS_CONSTANT_COLOR,[Kp]:i.CONSTANT_ALPHA,[Jp]:i.ONE_MINUS_CONSTANT_ALPHA};function Vt(k,ne,j,Ae,ve,Se,Be,tt,_e,He){if(k===Vr){m===!0&&(Xe(i.BLEND),m=!1);return}if(m===!1&&(me(i.BLEND),m=!0),k!==Dp){if(k!==g||He!==I){if((A!==Wr||T!==Wr)&&(i.blendEquation(i.FUNC_ADD),A=Wr,T=Wr),He)switch(k){case Ds:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lu:i.blendFunc(i.ONE,i.ONE);break;case cu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case hu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Je("WebGLState: Invalid blending: ",k);break}else switch(k){case Ds:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case cu:Je("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hu:Je("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Je("WebGLState: Invalid blending: ",k);break}M=null,w=null,E=null,x=null,b.set(0,0,0),P=0,g=k,I=He}return}ve=ve||ne,Se=Se||j,Be=Be||Ae,(ne!==A||ve!==T)&&(i.blendEquationSeparate(mt[ne],mt[ve]),A=ne,T=ve),(j!==M||Ae!==w||Se!==E||Be!==x)&&(i.blendFuncSeparate(at[j],at[Ae],at[Se],at[Be]),M=j,w=Ae,E=Se,x=Be),(tt.equals(b)===!1||_e!==P)&&(i.blendColor(tt.r,tt.g,tt.b,_e),b.copy(tt),P=_e),g=k,I=!1}function kt(k,ne){k.side===Nn?Xe(i.CULL_FACE):me(i.CULL_FACE);let j=k.side===un;ne&&(j=!j),on(j),k.blending===Ds&&k.transparent===!1?Vt(Vr):Vt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),s.setMask(k.colorWrite);let Ae=k.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),qt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?me(i.SAMPLE_ALPHA_TO_COVERAGE):Xe(i.SAMPLE_ALPHA_TO_COVERAGE)}function on(k){F!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),F=k)}function Ut(k){k!==Pp?(me(i.CULL_FACE),k!==B&&(k===au?i.cullFace(i.BACK):k===Lp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Xe(i.CULL_FACE),B=k}function Xn(k){k!==z&&(K&&i.lineWidth(k),z=k)}function qt(k,ne,j){k?(me(i.POLYGON_OFFSET_FILL),(D!==ne||$!==j)&&(D=ne,$=j,o.getReversed()&&(ne=-ne,j=-j),i.polygonOffset(ne,j))):Xe(i.POLYGON_OFFSET_FILL)}function _n(k){k?me(i.SCISSOR_TEST):Xe(i.SCISSOR_TEST)}function yn(k){k===void 0&&(k=i.TEXTURE0+q-1),ae!==k&&(i.activeTexture(k),ae=k)}function An(k,ne,j){j===void 0&&(ae===null?j=i.TEXTURE0+q-1:j=ae);let Ae=ce[j];Ae===void 0&&(Ae={type:void 0,texture:void 0},ce[j]=Ae),(Ae.type!==k||Ae.texture!==ne)&&(ae!==j&&(i.activeTexture(j),ae=j),i.bindTexture(k,ne||ze[k]),Ae.type=k,Ae.texture=ne)}function V(){let k=ce[ae];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function xn(){try{i.compressedTexImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function Ct(){try{i.compressedTexImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function It(){try{i.texSubImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function Ce(){try{i.texSubImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function Yt(){try{i.compressedTexSubImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function Ge(){try{i.compressedTexSubImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function je(){try{i.texStorage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function O(){try{i.texStorage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function R(){try{i.texImage2D(...arguments)}catch(k){Je("WebGLState:",k)}}function Z(){try{i.texImage3D(...arguments)}catch(k){Je("WebGLState:",k)}}function ge(k){return u[k]!==void 0?u[k]:i.getParameter(k)}function le(k,ne){u[k]!==ne&&(i.pixelStorei(k,ne),u[k]=ne)}function be(k){ie.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),ie.copy(k))}function Ie(k){Re.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),Re.copy(k))}function te(k,ne){let j=c.get(ne);j===void 0&&(j=new WeakMap,c.set(ne,j));let Ae=j.get(k);Ae===void 0&&(Ae=i.getUniformBlockIndex(ne,k.name),i.uniformBlockBinding(ne,Ae,Ae),j.set(k,Ae))}function re(k,ne,j){let ve=c.get(ne).get(k);l[ve]!==j&&(i.bindBufferBase(i.UNIFORM_BUFFER,ve,j),l[ve]=j)}function Me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ae=null,ce={},f={},l={},p=new WeakMap,v=[],y=null,m=!1,g=null,A=null,M=null,w=null,T=null,E=null,x=null,b=new $e(0,0,0),P=0,I=!1,F=null,B=null,z=null,D=null,$=null,ie.set(0,0,i.canvas.width,i.canvas.height),Re.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:me,disable:Xe,bindFramebuffer:wt,drawBuffers:Ve,useProgram:ft,setBlending:Vt,setMaterial:kt,setFlipSided:on,setCullFace:Ut,setLineWidth:Xn,setPolygonOffset:qt,setScissorTest:_n,activeTexture:yn,bindTexture:An,unbindTexture:V,compressedTexImage2D:xn,compressedTexImage3D:Ct,texImage2D:R,texImage3D:Z,pixelStorei:le,getParameter:ge,updateUBOMapping:te,uniformBlockBinding:re,texStorage2D:je,texStorage3D:O,texSubImage2D:It,texSubImage3D:Ce,compressedTexSubImage2D:Yt,compressedTexSubImage3D:Ge,scissor:be,viewport:Ie,reset:Me}}function KM(i,e,t,n,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,h=new WeakMap,u=new Set,f,p=new WeakMap,v=new Set,y=new FinalizationRegistry(O=>v.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(O,R){return m?new OffscreenCanvas(O,R):bs("canvas")}function A(O,R,Z){let ge=1,le=je(O);if((le.width>Z||le.height>Z)&&(ge=Z/Math.max(le.width,le.height)),ge<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let be=Math.floor(ge*le.width),Ie=Math.floor(ge*le.height);f===void 0&&(f=g(be,Ie));let te=R?g(be,Ie):f;return te.width=be,te.height=Ie,te.getContext("2d").drawImage(O,0,0,be,Ie),ke("WebGLRenderer: Texture has been resized from ("+le.width+"x"+le.height+") to ("+be+"x"+Ie+")."),te}else return"data"in O&&ke("WebGLRenderer: Image in DataTexture is too big ("+le.width+"x"+le.height+")."),O;return O}function M(O){return O.generateMipmaps}function w(O){i.generateMipmap(O)}function T(O){return O.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?i.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(O,R,Z,ge,le,be=!1){if(O!==null){if(i[O]!==void 0)return i[O];ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let Ie;ge&&(Ie=e.get("EXT_texture_norm16"),Ie||ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=R;if(R===i.RED&&(Z===i.FLOAT&&(te=i.R32F),Z===i.HALF_FLOAT&&(te=i.R16F),Z===i.UNSIGNED_BYTE&&(te=i.R8),Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.R16_EXT),Z===i.SHORT&&Ie&&(te=Ie.R16_SNORM_EXT)),R===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.R8UI),Z===i.UNSIGNED_SHORT&&(te=i.R16UI),Z===i.UNSIGNED_INT&&(te=i.R32UI),Z===i.BYTE&&(te=i.R8I),Z===i.SHORT&&(te=i.R16I),Z===i.INT&&(te=i.R32I)),R===i.RG&&(Z===i.FLOAT&&(te=i.RG32F),Z===i.HALF_FLOAT&&(te=i.RG16F),Z===i.UNSIGNED_BYTE&&(te=i.RG8),Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.RG16_EXT),Z===i.SHORT&&Ie&&(te=Ie.RG16_SNORM_EXT)),R===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.RG8UI),Z===i.UNSIGNED_SHORT&&(te=i.RG16UI),Z===i.UNSIGNED_INT&&(te=i.RG32UI),Z===i.BYTE&&(te=i.RG8I),Z===i.SHORT&&(te=i.RG16I),Z===i.INT&&(te=i.RG32I)),R===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(te=i.RGB16UI),Z===i.UNSIGNED_INT&&(te=i.RGB32UI),Z===i.BYTE&&(te=i.RGB8I),Z===i.SHORT&&(te=i.RGB16I),Z===i.INT&&(te=i.RGB32I)),R===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),Z===i.UNSIGNED_INT&&(te=i.RGBA32UI),Z===i.BYTE&&(te=i.RGBA8I),Z===i.SHORT&&(te=i.RGBA16I),Z===i.INT&&(te=i.RGBA32I)),R===i.RGB&&(Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.RGB16_EXT),Z===i.SHORT&&Ie&&(te=Ie.RGB16_SNORM_EXT),Z===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),Z===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),R===i.RGBA){let re=be?_o:st.getTransfer(le);Z===i.FLOAT&&(te=i.RGBA32F),Z===i.HALF_FLOAT&&(te=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(te=re===bt?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT&&Ie&&(te=Ie.RGBA16_EXT),Z===i.SHORT&&Ie&&(te=Ie.RGBA16_SNORM_EXT),Z===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(O,R){let Z;return O?R===null||R===ci||R===qr?Z=i.DEPTH24_STENCIL8:R===yt?Z=i.DEPTH32F_STENCIL8:R===Bs&&(Z=i.DEPTH24_STENCIL8,ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===ci||R===qr?Z=i.DEPTH_COMPONENT24:R===yt?Z=i.DEPTH_COMPONENT32F:R===Bs&&(Z=i.DEPTH_COMPONENT16),Z}function b(O,R){return M(O)===!0||O.isFramebufferTexture&&O.minFilter!==Mt&&O.minFilter!==Rt?Math.log2(Math.max(R.width,R.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?R.mipmaps.length:1}function P(O){let R=new WeakRef(O);n.get(O).__ref=R,v.add(R),y.register(O,R,R)}function I(O){let R=n.get(O).__ref;R!==void 0&&(v.delete(R),y.unregister(R))}function F(O){z(O.target)}function B(O){D(O.target)}function z(O){O.removeEventListener("dispose",F),I(O),q(O),O.isVideoTexture&&h.delete(O),O.isHTMLTexture&&u.delete(O)}function D(O){O.removeEventListener("dispose",B),I(O),fe(O)}function $(){for(let O of v){let R=O.deref();R!==void 0&&(R.isRenderTarget===!0?D(R):z(R))}v.clear(),u.clear()}function q(O){let R=n.get(O);if(R.__webglInit===void 0)return;let Z=O.source,ge=p.get(Z);if(ge){let le=ge[R.__cacheKey];le.usedTimes--,le.usedTimes===0&&K(O),Object.keys(ge).length===0&&p.delete(Z)}n.remove(O)}function K(O){let R=n.get(O);i.deleteTexture(R.__webglTexture);let Z=O.source,ge=p.get(Z);delete ge[R.__cacheKey],o.memory.textures--}function fe(O){let R=n.get(O);R.__depthDisposeCallback&&R.__depthDisposeCallback();let Z=O.depthTexture;if(Z&&Z.renderTarget===O&&z(Z),O.isWebGLCubeRenderTarget)for(let le=0;le<6;le++){if(Array.isArray(R.__webglFramebuffer[le]))for(let be=0;be<R.__webglFramebuffer[le].length;be++)i.deleteFramebuffer(R.__webglFramebuffer[le][be]);else i.deleteFramebuffer(R.__webglFramebuffer[le]);R.__webglDepthbuffer&&i.deleteRenderbuffer(R.__webglDepthbuffer[le])}else{if(Array.isArray(R.__webglFramebuffer))for(let le=0;le<R.__webglFramebuffer.length;le++)i.deleteFramebuffer(R.__webglFramebuffer[le]);else i.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&i.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&i.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let le=0;le<R.__webglColorRenderbuffer.length;le++)R.__webglColorRenderbuffer[le]&&i.deleteRenderbuffer(R.__webglColorRenderbuffer[le]);R.__webglDepthRenderbuffer&&i.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let ge=O.textures;for(let le=0,be=ge.length;le<be;le++){let Ie=n.get(ge[le]);Ie.__webglTexture&&(i.deleteTexture(Ie.__webglTexture),o.memory.textures--),n.remove(ge[le])}n.remove(O)}let J=0;function ae(){J=0}function ce(){return J}function we(O){J=O}function De(){let O=J;return O>=r.maxTextures&&ke("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+r.maxTextures),J+=1,O}function ie(O){let R=[];return R.push(O.wrapS),R.push(O.wrapT),R.push(O.wrapR||0),R.push(O.magFilter),R.push(O.minFilter),R.push(O.anisotropy),R.push(O.internalFormat),R.push(O.format),R.push(O.type),R.push(O.generateMipmaps),R.push(O.mipmapsAutoUpdate),R.push(O.premultiplyAlpha),R.push(O.flipY),R.push(O.unpackAlignment),R.push(O.colorSpace),R.join()}function Re(O,R){let Z=n.get(O);if(O.isVideoTexture&&Yt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&Z.__version!==O.version){let ge=O.image;if(ge===null)ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ge.complete===!1)ke("WebGLRenderer: Texture marked for update but image is incomplete");else{kt(Z,O,R);return}}else O.isExternalTexture&&(Z.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+R)}function Ue(O,R){let Z=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Z.__version!==O.version){kt(Z,O,R);return}else O.isExternalTexture&&(Z.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+R)}function ze(O,R){let Z=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&Z.__version!==O.version){kt(Z,O,R);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+R)}function me(O,R){let Z=n.get(O);if(O.version>0&&Z.__version!==O.version){on(Z,O,R);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+R)}let Xe={[yr]:i.REPEAT,[Rn]:i.CLAMP_TO_EDGE,[ys]:i.MIRRORED_REPEAT},wt={[Mt]:i.NEAREST,[Ol]:i.NEAREST_MIPMAP_NEAREST,[Xr]:i.NEAREST_MIPMAP_LINEAR,[Rt]:i.LINEAR,[Os]:i.LINEAR_MIPMAP_NEAREST,[Wn]:i.LINEAR_MIPMAP_LINEAR},Ve={[sm]:i.NEVER,[Ru]:i.ALWAYS,[om]:i.LESS,[Tu]:i.LEQUAL,[am]:i.EQUAL,[Eu]:i.GEQUAL,[lm]:i.GREATER,[cm]:i.NOTEQUAL};function ft(O,R){if(R.type===yt&&e.has("OES_texture_float_linear")===!1&&(R.magFilter===Rt||R.magFilter===Os||R.magFilter===Xr||R.magFilter===Wn||R.minFilter===Rt||R.minFilter===Os||R.minFilter===Xr||R.minFilter===Wn)&&ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(O,i.TEXTURE_WRAP_S,Xe[R.wrapS]),i.texParameteri(O,i.TEXTURE_WRAP_T,Xe[R.wrapT]),(O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY)&&i.texParameteri(O,i.TEXTURE_WRAP_R,Xe[R.wrapR]),i.texParameteri(O,i.TEXTURE_MAG_FILTER,wt[R.magFilter]),i.texParameteri(O,i.TEXTURE_MIN_FILTER,wt[R.minFilter]),R.compareFunction&&(i.texParameteri(O,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(O,i.TEXTURE_COMPARE_FUNC,Ve[R.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Mt||R.minFilter!==Xr&&R.minFilter!==Wn||R.type===yt&&e.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||n.get(R).__currentAnisotropy){let Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(O,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,r.getMaxAnisotropy())),n.get(R).__currentAnisotropy=R.anisotropy}}}function mt(O,R){let Z=!1;O.__webglInit===void 0&&(O.__webglInit=!0,R.addEventListener("dispose",F),P(R));let ge=R.source,le=p.get(ge);le===void 0&&(le={},p.set(ge,le));let be=ie(R);if(be!==O.__cacheKey){le[be]===void 0&&(le[be]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),le[be].usedTimes++;let Ie=le[O.__cacheKey];Ie!==void 0&&(le[O.__cacheKey].usedTimes--,Ie.usedTimes===0&&K(R)),O.__cacheKey=be,O.__webglTexture=le[be].texture}return Z}function at(O,R,Z){return Math.floor(Math.floor(O/Z)/R)}function Vt(O,R,Z,ge){let be=O.updateRanges;if(be.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,R.width,R.height,Z,ge,R.data);else{be.sort((k,ne)=>k.start-ne.start);let Ie=0;for(let k=1;k<be.length;k++){let ne=be[Ie],j=be[k],Ae=ne.start+ne.count,ve=at(j.start,R.width,4),Se=at(ne.start,R.width,4);j.start<=Ae+1&&ve===Se&&at(j.start+j.count-1,R.width,4)===ve?ne.count=Math.max(ne.count,j.start+j.count-ne.start):(++Ie,be[Ie]=j)}be.length=Ie+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),Me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,R.width);for(let k=0,ne=be.length;k<ne;k++){let j=be[k],Ae=Math.floor(j.start/4),ve=Math.ceil(j.count/4),Se=Ae%R.width,Be=Math.floor(Ae/R.width),tt=ve,_e=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Be),t.texSubImage2D(i.TEXTURE_2D,0,Se,Be,tt,_e,Z,ge,R.data)}O.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,Me)}}function kt(O,R,Z){let ge=i.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(ge=i.TEXTURE_2D_ARRAY),R.isData3DTexture&&(ge=i.TEXTURE_3D);let le=mt(O,R),be=R.source;t.bindTexture(ge,O.__webglTexture,i.TEXTURE0+Z);let Ie=n.get(be);if(be.version!==Ie.__version||le===!0){if(t.activeTexture(i.TEXTURE0+Z),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let _e=st.getPrimaries(st.workingColorSpace),He=R.colorSpace===ir?null:st.getPrimaries(R.colorSpace),Qe=R.colorSpace===ir||_e===He?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,R.unpackAlignment);let re=A(R.image,!1,r.maxTextureSize);re=Ge(R,re);let Me=s.convert(R.format,R.colorSpace),k=s.convert(R.type),ne=E(R.internalFormat,Me,k,R.normalized,R.colorSpace,R.isVideoTexture);ft(ge,R);let j,Ae=R.mipmaps,ve=R.isVideoTexture!==!0,Se=Ie.__version===void 0||le===!0,Be=be.dataReady,tt=b(R,re);if(R.isDepthTexture)ne=x(R.format===tr,R.type),Se&&(ve?t.texStorage2D(i.TEXTURE_2D,1,ne,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,ne,re.width,re.height,0,Me,k,null));else if(R.isDataTexture)if(Ae.length>0){ve&&Se&&t.texStorage2D(i.TEXTURE_2D,tt,ne,Ae[0].width,Ae[0].height);for(let _e=0,He=Ae.length;_e<He;_e++)j=Ae[_e],ve?Be&&t.texSubImage2D(i.TEXTURE_2D,_e,0,0,j.width,j.height,Me,k,j.data):t.texImage2D(i.TEXTURE_2D,_e,ne,j.width,j.height,0,Me,k,j.data);R.generateMipmaps=!1}else ve?(Se&&t.texStorage2D(i.TEXTURE_2D,tt,ne,re.width,re.height),Be&&Vt(R,re,Me,k)):t.texImage2D(i.TEXTURE_2D,0,ne,re.width,re.height,0,Me,k,re.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){ve&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,ne,Ae[0].width,Ae[0].height,re.depth);for(let _e=0,He=Ae.length;_e<He;_e++)if(j=Ae[_e],R.format!==xt)if(Me!==null)if(ve){if(Be)if(R.layerUpdates.size>0){let Qe=Ou(j.width,j.height,R.format,R.type);for(let Le of R.layerUpdates){let vt=j.data.subarray(Le*Qe/j.data.BYTES_PER_ELEMENT,(Le+1)*Qe/j.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,_e,0,0,Le,j.width,j.height,1,Me,vt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,_e,0,0,0,j.width,j.height,re.depth,Me,j.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,_e,ne,j.width,j.height,re.depth,0,j.data,0,0);else ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ve?Be&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,_e,0,0,0,j.width,j.height,re.depth,Me,k,j.data):t.texImage3D(i.TEXTURE_2D_ARRAY,_e,ne,j.width,j.height,re.depth,0,Me,k,j.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{ve&&Se&&t.texStorage2D(i.TEXTURE_2D,tt,ne,Ae[0].width,Ae[0].height);for(let _e=0,He=Ae.length;_e<He;_e++)j=Ae[_e],R.format!==xt?Me!==null?ve?Be&&t.compressedTexSubImage2D(i.TEXTURE_2D,_e,0,0,j.width,j.height,Me,j.data):t.compressedTexImage2D(i.TEXTURE_2D,_e,ne,j.width,j.height,0,j.data):ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ve?Be&&t.texSubImage2D(i.TEXTURE_2D,_e,0,0,j.width,j.height,Me,k,j.data):t.texImage2D(i.TEXTURE_2D,_e,ne,j.width,j.height,0,Me,k,j.data)}else if(R.isDataArrayTexture)if(ve){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,ne,re.width,re.height,re.depth),Be)if(R.layerUpdates.size>0){let _e=Ou(re.width,re.height,R.format,R.type);for(let He of R.layerUpdates){let Qe=re.data.subarray(He*_e/re.data.BYTES_PER_ELEMENT,(He+1)*_e/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,He,re.width,re.height,1,Me,k,Qe)}R.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,Me,k,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ne,re.width,re.height,re.depth,0,Me,k,re.data);else if(R.isData3DTexture)ve?(Se&&t.texStorage3D(i.TEXTURE_3D,tt,ne,re.width,re.height,re.depth),Be&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,Me,k,re.data)):t.texImage3D(i.TEXTURE_3D,0,ne,re.width,re.height,re.depth,0,Me,k,re.data);else if(R.isFramebufferTexture){if(Se)if(ve)t.texStorage2D(i.TEXTURE_2D,tt,ne,re.width,re.height);else{let _e=re.width,He=re.height;for(let Qe=0;Qe<tt;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,ne,_e,He,0,Me,k,null),_e>>=1,He>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in i){let _e=i.canvas;if(_e.hasAttribute("layoutsubtree")||_e.setAttribute("layoutsubtree","true"),re.parentNode!==_e){_e.appendChild(re),u.add(R),_e.onpaint=He=>{let Qe=He.changedElements;for(let Le of u)Qe.includes(Le.image)&&(Le.needsUpdate=!0)},_e.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let Qe=i.RGBA,Le=i.RGBA,vt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Le,vt,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ve&&Se){let _e=je(Ae[0]);t.texStorage2D(i.TEXTURE_2D,tt,ne,_e.width,_e.height)}for(let _e=0,He=Ae.length;_e<He;_e++)j=Ae[_e],ve?Be&&t.texSubImage2D(i.TEXTURE_2D,_e,0,0,Me,k,j):t.texImage2D(i.TEXTURE_2D,_e,ne,Me,k,j);R.generateMipmaps=!1}else if(ve){if(Se){let _e=je(re);t.texStorage2D(i.TEXTURE_2D,tt,ne,_e.width,_e.height)}Be&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Me,k,re)}else t.texImage2D(i.TEXTURE_2D,0,ne,Me,k,re);M(R)&&R.mipmapsAutoUpdate===!0&&w(ge),Ie.__version=be.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function on(O,R,Z){if(R.image.length!==6)return;let ge=mt(O,R),le=R.source;t.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+Z);let be=n.get(le);if(le.version!==be.__version||ge===!0){t.activeTexture(i.TEXTURE0+Z);let Ie=st.getPrimaries(st.workingColorSpace),te=R.colorSpace===ir?null:st.getPrimaries(R.colorSpace),re=R.colorSpace===ir||Ie===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,R.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let Me=R.isCompressedTexture||R.image[0].isCompressedTexture,k=R.image[0]&&R.image[0].isDataTexture,ne=[];for(let Le=0;Le<6;Le++)!Me&&!k?ne[Le]=A(R.image[Le],!0,r.maxCubemapSize):ne[Le]=k?R.image[Le].image:R.image[Le],ne[Le]=Ge(R,ne[Le]);let j=ne[0],Ae=s.convert(R.format,R.colorSpace),ve=s.convert(R.type),Se=E(R.internalFormat,Ae,ve,R.normalized,R.colorSpace),Be=R.isVideoTexture!==!0,tt=be.__version===void 0||ge===!0,_e=le.dataReady,He=b(R,j);ft(i.TEXTURE_CUBE_MAP,R);let Qe;if(R.isDepthTexture){if(Se=x(R.format===tr,R.type),tt)if(Be)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,j.width,j.height);else for(let Le=0;Le<6;Le++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,Se,j.width,j.height,0,Ae,ve,null)}else if(Me){Be&&tt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Se,j.width,j.height);for(let Le=0;Le<6;Le++){Qe=ne[Le].mipmaps;for(let vt=0;vt<Qe.length;vt++){let jt=Qe[vt];R.format!==xt?Ae!==null?Be?_e&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,0,0,jt.width,jt.height,Ae,jt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,Se,jt.width,jt.height,0,jt.data):ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,0,0,jt.width,jt.height,Ae,ve,jt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt,Se,jt.width,jt.height,0,Ae,ve,jt.data)}}}else{if(Qe=R.mipmaps,Be&&tt){Qe.length>0&&He++;let Le=je(ne[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Se,Le.width,Le.height)}for(let Le=0;Le<6;Le++)if(k){Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,0,0,ne[Le].width,ne[Le].height,Ae,ve,ne[Le].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,Se,ne[Le].width,ne[Le].height,0,Ae,ve,ne[Le].data);for(let vt=0;vt<Qe.length;vt++){let ui=Qe[vt].image[Le].image;Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,0,0,ui.width,ui.height,Ae,ve,ui.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,Se,ui.width,ui.height,0,Ae,ve,ui.data)}}else{Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,0,0,Ae,ve,ne[Le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,Se,Ae,ve,ne[Le]);for(let vt=0;vt<Qe.length;vt++){let jt=Qe[vt];Be?_e&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,0,0,Ae,ve,jt.image[Le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,vt+1,Se,Ae,ve,jt.image[Le])}}}M(R)&&R.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),be.__version=le.version,R.onUpdate&&R.onUpdate(R)}O.__version=R.version}function Ut(O,R,Z,ge,le,be){let Ie=s.convert(Z.format,Z.colorSpace),te=s.convert(Z.type),re=E(Z.internalFormat,Ie,te,Z.normalized,Z.colorSpace),Me=n.get(R),k=n.get(Z);if(k.__renderTarget=R,!Me.__hasExternalTextures){let ne=Math.max(1,R.width>>be),j=Math.max(1,R.height>>be);le===i.TEXTURE_3D||le===i.TEXTURE_2D_ARRAY?t.texImage3D(le,be,re,ne,j,R.depth,0,Ie,te,null):t.texImage2D(le,be,re,ne,j,0,Ie,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,O),Ce(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ge,le,k.__webglTexture,0,It(R)):(le===i.TEXTURE_2D||le>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&le<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ge,le,k.__webglTexture,be),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Xn(O,R,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,O),R.depthBuffer){let ge=R.depthTexture,le=ge&&ge.isDepthTexture?ge.type:null,be=x(R.stencilBuffer,le),Ie=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ce(R)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,It(R),be,R.width,R.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,It(R),be,R.width,R.height):i.renderbufferStorage(i.RENDERBUFFER,be,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ie,i.RENDERBUFFER,O)}else{let ge=R.textures;for(let le=0;le<ge.length;le++){let be=ge[le],Ie=s.convert(be.format,be.colorSpace),te=s.convert(be.type),re=E(be.internalFormat,Ie,te,be.normalized,be.colorSpace);Ce(R)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,It(R),re,R.width,R.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,It(R),re,R.width,R.height):i.renderbufferStorage(i.RENDERBUFFER,re,R.width,R.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function qt(O,R,Z){let ge=R.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,O),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let le=n.get(R.depthTexture);le.__renderTarget=R;let be=ge?R.depthTexture.image[0]:R.depthTexture.image;(!le.__webglTexture||be.width!==R.width||be.height!==R.height)&&(be.width=R.width,be.height=R.height,R.depthTexture.needsUpdate=!0),ge?me(R.depthTexture,0):Re(R.depthTexture,0);let Ie=le.__webglTexture,te=It(R),re=ge?i.TEXTURE_CUBE_MAP_POSITIVE_X+Z:i.TEXTURE_2D,Me=R.depthTexture.format===tr?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(R.depthTexture.format===Wi)Ce(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Me,re,Ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,Me,re,Ie,0);else if(R.depthTexture.format===tr)Ce(R)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Me,re,Ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,Me,re,Ie,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(O){let R=n.get(O),Z=O.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==O.depthTexture){let ge=O.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),ge){let le=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,ge.removeEventListener("dispose",le)};ge.addEventListener("dispose",le),R.__depthDisposeCallback=le}R.__boundDepthTexture=ge}if(O.depthTexture&&!R.__autoAllocateDepthBuffer)if(Z)for(let ge=0;ge<6;ge++)qt(R.__webglFramebuffer[ge],O,ge);else O.texture.mipmaps.length>0?qt(R.__webglFramebuffer[0],O,0):qt(R.__webglFramebuffer,O,0);else if(Z){R.__webglDepthbuffer=[];for(let ge=0;ge<6;ge++)if(t.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer[ge]),R.__webglDepthbuffer[ge]===void 0)R.__webglDepthbuffer[ge]=i.createRenderbuffer(),Xn(R.__webglDepthbuffer[ge],O,!1);else{let le=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=R.__webglDepthbuffer[ge];i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=i.createRenderbuffer(),Xn(R.__webglDepthbuffer,O,!1);else{let le=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=R.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function yn(O,R,Z){let ge=n.get(O);R!==void 0&&Ut(ge.__webglFramebuffer,O,O.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&_n(O)}function An(O){let R=O.texture,Z=n.get(O),ge=n.get(R);O.addEventListener("dispose",B),P(O);let le=O.textures,be=O.isWebGLCubeRenderTarget===!0,Ie=le.length>1;if(Ie||(ge.__webglTexture===void 0&&(ge.__webglTexture=i.createTexture()),ge.__version=R.version,o.memory.textures++),be){Z.__webglFramebuffer=[];for(let te=0;te<6;te++)if(R.mipmaps.length>0){Z.__webglFramebuffer[te]=[];for(let re=0;re<R.mipmaps.length;re++)Z.__webglFramebuffer[te][re]=i.createFramebuffer()}else Z.__webglFramebuffer[te]=i.createFramebuffer()}else{if(R.mipmaps.length>0){Z.__webglFramebuffer=[];for(let te=0;te<R.mipmaps.length;te++)Z.__webglFramebuffer[te]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(Ie)for(let te=0,re=le.length;te<re;te++){let Me=n.get(le[te]);Me.__webglTexture===void 0&&(Me.__webglTexture=i.createTexture(),o.memory.textures++)}if(O.samples>0&&Ce(O)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let te=0;te<le.length;te++){let re=le[te];Z.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[te]);let Me=s.convert(re.format,re.colorSpace),k=s.convert(re.type),ne=E(re.internalFormat,Me,k,re.normalized,re.colorSpace,O.isXRRenderTarget===!0),j=It(O);i.renderbufferStorageMultisample(i.RENDERBUFFER,j,ne,O.width,O.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,Z.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),O.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),Xn(Z.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(be){t.bindTexture(i.TEXTURE_CUBE_MAP,ge.__webglTexture),ft(i.TEXTURE_CUBE_MAP,R);for(let te=0;te<6;te++)if(R.mipmaps.length>0)for(let re=0;re<R.mipmaps.length;re++)Ut(Z.__webglFramebuffer[te][re],O,R,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,re);else Ut(Z.__webglFramebuffer[te],O,R,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);M(R)?w(i.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}else if(Ie){for(let te=0,re=le.length;te<re;te++){let Me=le[te],k=n.get(Me),ne=i.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ne=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,k.__webglTexture),ft(ne,Me),Ut(Z.__webglFramebuffer,O,Me,i.COLOR_ATTACHMENT0+te,ne,0),M(Me)&&w(ne)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(te=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ge.__webglTexture),ft(te,R),R.mipmaps.length>0)for(let re=0;re<R.mipmaps.length;re++)Ut(Z.__webglFramebuffer[re],O,R,i.COLOR_ATTACHMENT0,te,re);else Ut(Z.__webglFramebuffer,O,R,i.COLOR_ATTACHMENT0,te,0);M(R)?w(te):R.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&_n(O)}function V(O){let R=O.textures;for(let Z=0,ge=R.length;Z<ge;Z++){let le=R[Z];if(M(le)&&le.mipmapsAutoUpdate===!0){let be=T(O),Ie=n.get(le).__webglTexture;t.bindTexture(be,Ie),w(be),t.unbindTexture()}}}let xn=[];function Ct(O){if(O.samples>0){if(Ce(O)===!1){let R=O.textures,Z=O.width,ge=O.height,le=i.COLOR_BUFFER_BIT,be=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ie=n.get(O),te=R.length>1;if(te)for(let Me=0;Me<R.length;Me++)t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ie.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ie.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ie.__webglFramebuffer);for(let Me=0;Me<R.length;Me++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(le|=i.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(le|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ie.__webglColorRenderbuffer[Me]);let k=n.get(R[Me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,Z,ge,0,0,Z,ge,le,i.NEAREST),l===!0&&(xn.length=0,xn.push(i.COLOR_ATTACHMENT0+Me),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&xn.push(be),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,xn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let Me=0;Me<R.length;Me++){t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.RENDERBUFFER,Ie.__webglColorRenderbuffer[Me]);let k=n.get(R[Me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ie.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ie.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let R=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[R])}}}function It(O){return Math.min(r.maxSamples,O.samples)}function Ce(O){let R=n.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Yt(O){let R=o.render.frame;h.get(O)!==R&&(h.set(O,R),O.update())}function Ge(O,R){let Z=O.colorSpace,ge=O.format,le=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||Z!==Lt&&Z!==ir&&(st.getTransfer(Z)===bt?(ge!==xt||le!==Dn)&&ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Je("WebGLTextures: Unsupported texture color space:",Z)),R}function je(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=De,this.resetTextureUnits=ae,this.getTextureUnits=ce,this.setTextureUnits=we,this.setTexture2D=Re,this.setTexture2DArray=Ue,this.setTexture3D=ze,this.setTextureCube=me,this.rebindTextures=yn,this.setupRenderTarget=An,this.updateRenderTargetMipmap=V,this.updateMultisampleRenderTarget=Ct,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Ce,this.dispose=$}function JM(i,e){function t(n,r=ir){let s,o=st.getTransfer(r);if(n===Dn)return i.UNSIGNED_BYTE;if(n===kl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===zl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===bu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Mu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yu)return i.BYTE;if(n===xu)return i.SHORT;if(n===Bs)return i.UNSIGNED_SHORT;if(n===Bl)return i.INT;if(n===ci)return i.UNSIGNED_INT;if(n===yt)return i.FLOAT;if(n===Jt)return i.HALF_FLOAT;if(n===Su)return i.ALPHA;if(n===wu)return i.RGB;if(n===xt)return i.RGBA;if(n===Wi)return i.DEPTH_COMPONENT;if(n===tr)return i.DEPTH_STENCIL;if(n===nr)return i.RED;if(n===Hl)return i.RED_INTEGER;if(n===Fn)return i.RG;if(n===Gl)return i.RG_INTEGER;if(n===Vl)return i.RGBA_INTEGER;if(n===qo||n===Yo||n===Zo||n===Ko)if(o===bt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===qo)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Yo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Zo)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ko)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===qo)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Yo)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Zo)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ko)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Wl||n===$l||n===Xl||n===ql)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===Wl)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===$l)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Xl)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ql)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Yl||n===Zl||n===Kl||n===Jl||n===jl||n===Jo||n===Ql)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(n===Yl||n===Zl)return o===bt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===Kl)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===Jl)return s.COMPRESSED_R11_EAC;if(n===jl)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Jo)return s.COMPRESSED_RG11_EAC;if(n===Ql)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ec||n===tc||n===nc||n===ic||n===rc||n===sc||n===oc||n===ac||n===lc||n===cc||n===hc||n===uc||n===fc||n===dc)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(n===ec)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===tc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===nc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ic)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===rc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===oc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ac)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===lc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===cc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===hc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===uc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===fc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===dc)return o===bt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===pc||n===mc||n===gc)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(n===pc)return o===bt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===mc)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===gc)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===vc||n===_c||n===jo||n===yc)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(n===vc)return s.COMPRESSED_RED_RGTC1_EXT;if(n===_c)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===jo)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===yc)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===qr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var jM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,QM=`
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

}`,Xu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new No(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Ft({vertexShader:jM,fragmentShader:QM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new St(new li(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},qu=class extends bi{constructor(e,t){super();let n=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,p=null,v=null,y=typeof XRWebGLBinding<"u",m=new Xu,g={},A=t.getContextAttributes(),M=null,w=null,T=[],E=[],x=new it,b=null,P=null,I=new Kt;I.viewport=new Tt;let F=new Kt;F.viewport=new Tt;let B=[I,F],z=new Dl,D=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ie){let Re=T[ie];return Re===void 0&&(Re=new ws,T[ie]=Re),Re.getTargetRaySpace()},this.getControllerGrip=function(ie){let Re=T[ie];return Re===void 0&&(Re=new ws,T[ie]=Re),Re.getGripSpace()},this.getHand=function(ie){let Re=T[ie];return Re===void 0&&(Re=new ws,T[ie]=Re),Re.getHandSpace()};function q(ie){let Re=E.indexOf(ie.inputSource);if(Re===-1)return;let Ue=T[Re];Ue!==void 0&&(Ue.update(ie.inputSource,ie.frame,c||o),Ue.dispatchEvent({type:ie.type,data:ie.inputSource}))}function K(){r.removeEventListener("select",q),r.removeEventListener("selectstart",q),r.removeEventListener("selectend",q),r.removeEventListener("squeeze",q),r.removeEventListener("squeezestart",q),r.removeEventListener("squeezeend",q),r.removeEventListener("end",K),r.removeEventListener("inputsourceschange",fe);for(let ie=0;ie<T.length;ie++){let Re=E[ie];Re!==null&&(E[ie]=null,T[ie].disconnect(Re))}D=null,$=null,m.reset();for(let ie in g)delete g[ie];if(e.setRenderTarget(M),p=null,f=null,u=null,r=null,w=null,De.stop(),n.isPresenting=!1,e.setPixelRatio(b),e.setSize(x.width,x.height,!1),P!==null){let ie=P.camera;ie.fov=P.fov,ie.zoom=P.zoom,ie.updateProjectionMatrix(),P=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ie){s=ie,n.isPresenting===!0&&ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ie){a=ie,n.isPresenting===!0&&ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ie){c=ie},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(r,t)),u},this.getFrame=function(){return v},this.getSession=function(){return r},this.setSession=async function(ie){if(r=ie,r!==null){if(M=e.getRenderTarget(),r.addEventListener("select",q),r.addEventListener("selectstart",q),r.addEventListener("selectend",q),r.addEventListener("squeeze",q),r.addEventListener("squeezestart",q),r.addEventListener("squeezeend",q),r.addEventListener("end",K),r.addEventListener("inputsourceschange",fe),A.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Ue=null,ze=null,me=null;A.depth&&(me=A.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Ue=A.stencil?tr:Wi,ze=A.stencil?qr:ci);let Xe={colorFormat:t.RGBA8,depthFormat:me,scaleFactor:s};u=this.getBinding(),f=u.createProjectionLayer(Xe),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),w=new tn(f.textureWidth,f.textureHeight,{format:xt,type:Dn,depthTexture:new Yi(f.textureWidth,f.textureHeight,ze,void 0,void 0,void 0,void 0,void 0,void 0,Ue),stencilBuffer:A.stencil,colorSpace:e.outputColorSpace,samples:A.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let Ue={antialias:A.antialias,alpha:!0,depth:A.depth,stencil:A.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,Ue),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),w=new tn(p.framebufferWidth,p.framebufferHeight,{format:xt,type:Dn,colorSpace:e.outputColorSpace,stencilBuffer:A.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),De.setContext(r),De.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function fe(ie){for(let Re=0;Re<ie.removed.length;Re++){let Ue=ie.removed[Re],ze=E.indexOf(Ue);ze>=0&&(E[ze]=null,T[ze].disconnect(Ue))}for(let Re=0;Re<ie.added.length;Re++){let Ue=ie.added[Re],ze=E.indexOf(Ue);if(ze===-1){for(let Xe=0;Xe<T.length;Xe++)if(Xe>=E.length){E.push(Ue),ze=Xe;break}else if(E[Xe]===null){E[Xe]=Ue,ze=Xe;break}if(ze===-1)break}let me=T[ze];me&&me.connect(Ue)}}function J(ie,Re){Re===null?ie.matrixWorld.copy(ie.matrix):ie.matrixWorld.multiplyMatrices(Re.matrixWorld,ie.matrix),ie.matrixWorldInverse.copy(ie.matrixWorld).invert()}this.updateCamera=function(ie){if(r===null)return;let Re=ie.near,Ue=ie.far;m.texture!==null&&(m.depthNear>0&&(Re=m.depthNear),m.depthFar>0&&(Ue=m.depthFar)),z.near=F.near=I.near=Re,z.far=F.far=I.far=Ue,(D!==z.near||$!==z.far)&&(r.updateRenderState({depthNear:z.near,depthFar:z.far}),D=z.near,$=z.far),z.layers.mask=ie.layers.mask|6,I.layers.mask=z.layers.mask&-5,F.layers.mask=z.layers.mask&-3;let ze=ie.parent,me=z.cameras;J(z,ze);for(let Xe=0;Xe<me.length;Xe++)J(me[Xe],ze);z.projectionMatrix.copy(I.projectionMatrix),z.projectionMatrixInverse.copy(I.projectionMatrixInverse),P===null&&ie.isPerspectiveCamera&&(P={camera:ie,fov:ie.fov,zoom:ie.zoom}),ae(ie,z,ze)};function ae(ie,Re,Ue){Ue===null?ie.matrix.copy(Re.matrixWorld):(ie.matrix.copy(Ue.matrixWorld),ie.matrix.invert(),ie.matrix.multiply(Re.matrixWorld)),ie.matrix.decompose(ie.position,ie.quaternion,ie.scale),ie.updateMatrixWorld(!0),ie.projectionMatrix.copy(Re.projectionMatrix),ie.projectionMatrixInverse.copy(Re.projectionMatrixInverse),ie.isPerspectiveCamera&&(ie.fov=Ur*2*Math.atan(1/ie.projectionMatrix.elements[5]),ie.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(ie){l=ie,f!==null&&(f.fixedFoveation=ie),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ie)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(ie){return g[ie]};let ce=null;function we(ie,Re){if(h=Re.getViewerPose(c||o),v=Re,h!==null){let Ue=h.views;p!==null&&(e.setRenderTargetFramebuffer(w,p.framebuffer),e.setRenderTarget(w));let ze=!1;Ue.length!==z.cameras.length&&(z.cameras.length=0,ze=!0);for(let Ve=0;Ve<Ue.length;Ve++){let ft=Ue[Ve],mt=null;if(p!==null)mt=p.getViewport(ft);else{let Vt=u.getViewSubImage(f,ft);mt=Vt.viewport,Ve===0&&(e.setRenderTargetTextures(w,Vt.colorTexture,Vt.depthStencilTexture),e.setRenderTarget(w))}let at=B[Ve];at===void 0&&(at=new Kt,at.layers.enable(Ve),at.viewport=new Tt,B[Ve]=at),at.matrix.fromArray(ft.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(ft.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(mt.x,mt.y,mt.width,mt.height),Ve===0&&(z.matrix.copy(at.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),ze===!0&&z.cameras.push(at)}let me=r.enabledFeatures;if(me&&me.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ve=u.getDepthInformation(Ue[0]);Ve&&Ve.isValid&&Ve.texture&&m.init(Ve,r.renderState)}if(me&&me.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Ve=0;Ve<Ue.length;Ve++){let ft=Ue[Ve].camera;if(ft){let mt=g[ft];mt||(mt=new No,g[ft]=mt);let at=u.getCameraImage(ft);mt.sourceTexture=at}}}}for(let Ue=0;Ue<T.length;Ue++){let ze=E[Ue],me=T[Ue];ze!==null&&me!==void 0&&me.update(ze,Re,c||o)}ce&&ce(ie,Re),Re.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Re}),v=null}let De=new km;De.setAnimationLoop(we),this.setAnimationLoop=function(ie){ce=ie},this.dispose=function(){}}},eS=new et,Zm=new Ke;Zm.set(-1,0,0,0,1,0,0,0,1);function tS(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Du(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function r(m,g,A,M,w){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(m,g):g.isMeshLambertMaterial?(s(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(m,g),u(m,g)):g.isMeshPhongMaterial?(s(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(m,g),f(m,g),g.isMeshPhysicalMaterial&&p(m,g,w)):g.isMeshMatcapMaterial?(s(m,g),v(m,g)):g.isMeshDepthMaterial?s(m,g):g.isMeshDistanceMaterial?(s(m,g),y(m,g)):g.isMeshNormalMaterial?s(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,A,M):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===un&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===un&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let A=e.get(g),M=A.envMap,w=A.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(eS.makeRotationFromEuler(w)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Zm),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,A,M){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*A,m.scale.value=M*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function f(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function p(m,g,A){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===un&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=A.texture,m.transmissionSamplerSize.value.set(A.width,A.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function v(m,g){g.matcap&&(m.matcap.value=g.matcap)}function y(m,g){let A=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(A.matrixWorld),m.nearDistance.value=A.shadow.camera.near,m.farDistance.value=A.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function nS(i,e,t,n){let r={},s={};function o(A,M){let w=M.program;n.uniformBlockBinding(A,w,r[A.id])}function a(A,M){let w=r[A.id];w===void 0&&(v(A),w=l(A),r[A.id]=w,A.addEventListener("dispose",m));let T=M.program;n.updateUBOMapping(A,T);let E=e.render.frame;s[A.id]!==E&&(c(A),s[A.id]=E)}function l(A){let M=i.createBuffer(),w=A.__size,T=A.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,w,T),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(A){let M=r[A.id],w=A.uniforms,T=A.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let E=0,x=w.length;E<x;E++){let b=w[E];if(Array.isArray(b))for(let P=0,I=b.length;P<I;P++)h(b[P],E,P,T);else h(b,E,0,T)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(A,M,w,T){if(f(A,M,w,T)===!0){let E=A.__offset,x=A.value;if(Array.isArray(x)){let b=0;for(let P=0;P<x.length;P++){let I=x[P],F=y(I,!0);u(I,A.__data,b),b+=F.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,A.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,A.__data)}}function u(A,M,w){typeof A=="number"||typeof A=="boolean"?M[w]=A:A.isMatrix3?(M[w]=A.elements[0],M[w+1]=A.elements[1],M[w+2]=A.elements[2],M[w+3]=0,M[w+4]=A.elements[3],M[w+5]=A.elements[4],M[w+6]=A.elements[5],M[w+7]=0,M[w+8]=A.elements[6],M[w+9]=A.elements[7],M[w+10]=A.elements[8],M[w+11]=0):ArrayBuffer.isView(A)?M.set(A.subarray(0,M.length-w),w):A.toArray(M,w)}function f(A,M,w,T){let E=A.value,x=M+"_"+w;if(Array.isArray(E)){T[x]===void 0&&(T[x]=[]);let b=T[x],P=!1;for(let I=0;I<E.length;I++)p(E[I],b,I)===!0&&(P=!0);return P}return p(E,T,x)}function p(A,M,w){if(M[w]===void 0)return typeof A=="number"||typeof A=="boolean"?M[w]=A:ArrayBuffer.isView(A)?M[w]=A.slice():M[w]=A.clone(),!0;{let T=M[w];if(typeof A=="number"||typeof A=="boolean"){if(T!==A)return M[w]=A,!0}else{if(ArrayBuffer.isView(A))return!0;if(T.equals(A)===!1)return T.copy(A),!0}}return!1}function v(A){let M=A.uniforms,w=0,T=16;for(let x=0,b=M.length;x<b;x++){let P=Array.isArray(M[x])?M[x]:[M[x]];for(let I=0,F=P.length;I<F;I++){let B=P[I],z=Array.isArray(B.value)?B.value:[B.value],D=Array.isArray(M[x])||Array.isArray(B.value),$=w;for(let K=0,fe=z.length;K<fe;K++){let J=z[K],ae=y(J,D),ce=w%T,we=ce%ae.boundary,De=ce+we;w+=we,De!==0&&T-De<ae.storage&&(w+=T-De),K===0&&($=w),w+=ae.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((w-$)/Float32Array.BYTES_PER_ELEMENT),B.__offset=$}}let E=w%T;return E>0&&(w+=T-E),A.__size=w,A.__cache={},this}function y(A,M){let w={boundary:0,storage:0};return typeof A=="number"||typeof A=="boolean"?(w.boundary=4,w.storage=4):A.isVector2?(w.boundary=8,w.storage=8):A.isVector3||A.isColor?(w.boundary=16,w.storage=12):A.isVector4?(w.boundary=16,w.storage=16):A.isMatrix3?(w.boundary=16,w.storage=48):A.isMatrix4?(w.boundary=16,w.storage=64):A.isTexture?ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(A)?(w.boundary=16,w.storage=A.byteLength):ke("WebGLRenderer: Unsupported uniform value type.",A),M===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function m(A){let M=A.target;M.removeEventListener("dispose",m),i.deleteBuffer(r[M.id]),delete r[M.id],delete s[M.id]}function g(){for(let A in r)i.deleteBuffer(r[A]);r={},s={}}return{bind:o,update:a,dispose:g}}var iS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ti=null;function rS(){return Ti===null&&(Ti=new gn(iS,16,16,Fn,Jt),Ti.name="DFG_LUT",Ti.minFilter=Rt,Ti.magFilter=Rt,Ti.wrapS=Rn,Ti.wrapT=Rn,Ti.generateMipmaps=!1,Ti.needsUpdate=!0),Ti}var Tc=class{constructor(e={}){let{canvas:t=hm(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:p=Dn}=e;this.isWebGLRenderer=!0;let v;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");v=n.getContextAttributes().alpha}else v=o;let y=p,m=new Set([Vl,Gl,Hl]),g=new Set([Dn,ci,Bs,qr,kl,zl]),A=new Uint32Array(4),M=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},T=null,E=null,x=[],b=[],P=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=wi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,F=!1,B=null,z=null,D=null,$=null;this._outputColorSpace=Xt;let q=0,K=0,fe=null,J=-1,ae=null,ce=new Tt,we=new Tt,De=null,ie=new $e(0),Re=0,Ue=t.width,ze=t.height,me=1,Xe=null,wt=null,Ve=new Tt(0,0,Ue,ze),ft=new Tt(0,0,Ue,ze),mt=!1,at=new xr,Vt=new yl,kt=!1,on=!1,Ut=new et,Xn=new W,qt=new Tt,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},yn=!1;function An(){return fe===null?me:1}let V=n;function xn(d,S){return t.getContext(d,S)}let Ct,It,Ce,Yt,Ge,je,O,R,Z,ge,le,be,Ie,te,re,Me,k,ne,j,Ae,ve,Se,Be;try{let d={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",He,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Le,!1),V===null){let S="webgl2";if(V=xn(S,d),V===null)throw xn(S)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(d){throw t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Le,!1),Je("WebGLRenderer: "+d.message),d}function tt(){Ct=new mb(V),Ct.init(),ve=new JM(V,Ct),It=new rb(V,Ct,e,ve),Ce=new ZM(V,Ct),It.reversedDepthBuffer&&f&&Ce.buffers.depth.setReversed(!0),z=V.createFramebuffer(),D=V.createFramebuffer(),$=V.createFramebuffer(),Yt=new _b(V),Ge=new FM,je=new KM(V,Ct,Ce,Ge,It,ve,Yt),O=new pb(I),R=new x_(V),Se=new nb(V,R),Z=new gb(V,R,Yt,Se),ge=new xb(V,Z,R,Se,Yt),ne=new yb(V,It,je),re=new sb(Ge),le=new DM(I,O,Ct,It,Se,re),be=new tS(I,Ge),Ie=new OM,te=new VM(Ct),k=new tb(I,O,Ce,ge,v,l),Me=new YM(I,ge,It),Be=new nS(V,Yt,It,Ce),j=new ib(V,Ct,Yt),Ae=new vb(V,Ct,Yt),Yt.programs=le.programs,I.capabilities=It,I.extensions=Ct,I.properties=Ge,I.renderLists=Ie,I.shadowMap=Me,I.state=Ce,I.info=Yt}y!==Dn&&(P=new Mb(y,t.width,t.height,a,r,s));let _e=new qu(I,V);this.xr=_e,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let d=Ct.get("WEBGL_lose_context");d&&d.loseContext()},this.forceContextRestore=function(){let d=Ct.get("WEBGL_lose_context");d&&d.restoreContext()},this.getPixelRatio=function(){return me},this.setPixelRatio=function(d){d!==void 0&&(me=d,this.setSize(Ue,ze,!1))},this.getSize=function(d){return d.set(Ue,ze)},this.setSize=function(d,S,C=!0){if(_e.isPresenting){ke("WebGLRenderer: Can't change size while VR device is presenting.");return}Ue=d,ze=S,t.width=Math.floor(d*me),t.height=Math.floor(S*me),C===!0&&(t.style.width=d+"px",t.style.height=S+"px"),P!==null&&P.setSize(t.width,t.height),this.setViewport(0,0,d,S)},this.getDrawingBufferSize=function(d){return d.set(Ue*me,ze*me).floor()},this.setDrawingBufferSize=function(d,S,C){Ue=d,ze=S,me=C,t.width=Math.floor(d*C),t.height=Math.floor(S*C),this.setViewport(0,0,d,S)},this.setEffects=function(d){if(y===Dn){Je("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(d){for(let S=0;S<d.length;S++)if(d[S].isOutputPass===!0){ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}P.setEffects(d||[])},this.getCurrentViewport=function(d){return d.copy(ce)},this.getViewport=function(d){return d.copy(Ve)},this.setViewport=function(d,S,C,L){d.isVector4?Ve.set(d.x,d.y,d.z,d.w):Ve.set(d,S,C,L),Ce.viewport(ce.copy(Ve).multiplyScalar(An()).round())},this.getScissor=function(d){return d.copy(ft)},this.setScissor=function(d,S,C,L){d.isVector4?ft.set(d.x,d.y,d.z,d.w):ft.set(d,S,C,L),Ce.scissor(we.copy(ft).multiplyScalar(An()).round())},this.getScissorTest=function(){return mt},this.setScissorTest=function(d){Ce.setScissorTest(mt=d)},this.setOpaqueSort=function(d){Xe=d},this.setTransparentSort=function(d){wt=d},this.getClearColor=function(d){return d.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(d=!0,S=!0,C=!0){let L=0;if(d){let U=!1;if(fe!==null){let N=fe.texture.format;U=m.has(N)}if(U){let N=fe.texture.type,X=g.has(N),H=k.getClearColor(),G=k.getClearAlpha(),Y=H.r,se=H.g,Q=H.b;X?(A[0]=Y,A[1]=se,A[2]=Q,A[3]=G,V.clearBufferuiv(V.COLOR,0,A)):(M[0]=Y,M[1]=se,M[2]=Q,M[3]=G,V.clearBufferiv(V.COLOR,0,M))}else L|=V.COLOR_BUFFER_BIT}S&&(L|=V.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),C&&(L|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),L!==0&&V.clear(L)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(d){d.setRenderer(this),B=d},this.dispose=function(){t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Le,!1),k.dispose(),Ie.dispose(),te.dispose(),je.dispose(),Ge.dispose(),O.dispose(),ge.dispose(),Z.dispose(),Se.dispose(),Be.dispose(),le.dispose(),_e.dispose(),_e.removeEventListener("sessionstart",qs),_e.removeEventListener("sessionend",ca),Ii.stop()};function He(d){d.preventDefault(),yo("WebGLRenderer: Context Lost."),F=!0}function Qe(){yo("WebGLRenderer: Context Restored."),F=!1;let d=Yt.autoReset,S=Me.enabled,C=Me.autoUpdate,L=Me.needsUpdate,U=Me.type;tt(),Yt.autoReset=d,Me.enabled=S,Me.autoUpdate=C,Me.needsUpdate=L,Me.type=U}function Le(d){Je("WebGLRenderer: A WebGL context could not be created. Reason: ",d.statusMessage)}function vt(d){let S=d.target;S.removeEventListener("dispose",vt),jt(S)}function jt(d){ui(d),Ge.remove(d)}function ui(d){let S=Ge.get(d).programs;S!==void 0&&(S.forEach(function(C){le.releaseProgram(C)}),d.isShaderMaterial&&le.releaseShaderCache(d))}this.renderBufferDirect=function(d,S,C,L,U,N){S===null&&(S=_n);let X=U.isMesh&&U.matrixWorld.determinantAffine()<0,H=pa(d,S,C,L,U);Ce.setMaterial(L,X);let G=C.index,Y=1;if(L.wireframe===!0){if(G=Z.getWireframeAttribute(C),G===void 0)return;Y=2}let se=C.drawRange,Q=C.attributes.position,ee=se.start*Y,ue=(se.start+se.count)*Y;N!==null&&(ee=Math.max(ee,N.start*Y),ue=Math.min(ue,(N.start+N.count)*Y)),G!==null?(ee=Math.max(ee,0),ue=Math.min(ue,G.count)):Q!=null&&(ee=Math.max(ee,0),ue=Math.min(ue,Q.count));let de=ue-ee;if(de<0||de===1/0)return;Se.setup(U,L,H,C,G);let pe,Te=j;if(G!==null&&(pe=R.get(G),Te=Ae,Te.setIndex(pe)),U.isMesh)L.wireframe===!0?(Ce.setLineWidth(L.wireframeLinewidth*An()),Te.setMode(V.LINES)):Te.setMode(V.TRIANGLES);else if(U.isLine){let We=L.linewidth;We===void 0&&(We=1),Ce.setLineWidth(We*An()),U.isLineSegments?Te.setMode(V.LINES):U.isLineLoop?Te.setMode(V.LINE_LOOP):Te.setMode(V.LINE_STRIP)}else U.isPoints?Te.setMode(V.POINTS):U.isSprite&&Te.setMode(V.TRIANGLES);if(U.isBatchedMesh)if(Ct.get("WEBGL_multi_draw"))Te.renderMultiDraw(U._multiDrawStarts,U._multiDrawCounts,U._multiDrawCount);else{let We=U._multiDrawStarts,he=U._multiDrawCounts,Ye=U._multiDrawCount,ye=G?R.get(G).bytesPerElement:1,Pe=Ge.get(L).currentProgram.getUniforms();for(let Ne=0;Ne<Ye;Ne++)Pe.setValue(V,"_gl_DrawID",Ne),Te.render(We[Ne]/ye,he[Ne])}else if(U.isInstancedMesh)Te.renderInstances(ee,de,U.count);else if(C.isInstancedBufferGeometry){let We=C._maxInstanceCount!==void 0?C._maxInstanceCount:1/0,he=Math.min(C.instanceCount,We);Te.renderInstances(ee,de,he)}else Te.render(ee,de)};function la(d,S,C,L){B!==null&&d.isNodeMaterial&&B.setObject(L,d),kt===!0&&re.setState(d,C,!1),d.transparent===!0&&d.side===Nn&&d.forceSinglePass===!1?(d.side=un,d.needsUpdate=!0,fi(d,S,L),d.side=Qn,d.needsUpdate=!0,fi(d,S,L),d.side=Nn):fi(d,S,L)}this.compile=function(d,S,C=null){C===null&&(C=d),B!==null&&B.renderStart(d,S,C),E=te.get(C),E.init(S),b.push(E),C.traverseVisible(function(U){U.isLight&&U.layers.test(S.layers)&&(E.pushLight(U),U.castShadow&&E.pushShadow(U))}),d!==C&&d.traverseVisible(function(U){U.isLight&&U.layers.test(S.layers)&&(E.pushLight(U),U.castShadow&&E.pushShadow(U))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),on=this.localClippingEnabled,kt=re.init(this.clippingPlanes,on),kt===!0&&re.setGlobalState(this.clippingPlanes,S),B!==null&&Me.render(E.state.shadowsArray,C,S);let L=new Set;return d.traverse(function(U){if(!(U.isMesh||U.isPoints||U.isLine||U.isSprite))return;let N=U.material;if(N)if(Array.isArray(N))for(let X=0;X<N.length;X++){let H=N[X];la(H,C,S,U),L.add(H)}else la(N,C,S,U),L.add(N)}),E=b.pop(),B!==null&&B.renderEnd(),L},this.compileAsync=function(d,S,C=null){let L=this.compile(d,S,C);return new Promise(U=>{function N(){if(L.forEach(function(X){let G=Ge.get(X).currentProgram;(G===void 0||G.isReady())&&L.delete(X)}),L.size===0){U(d);return}setTimeout(N,10)}Ct.get("KHR_parallel_shader_compile")!==null?N():setTimeout(N,10)})};let Xs=null;function nh(d){Xs&&Xs(d)}function qs(){Ii.stop()}function ca(){Ii.start()}let Ii=new km;Ii.setAnimationLoop(nh),typeof self<"u"&&Ii.setContext(self),this.setAnimationLoop=function(d){Xs=d,_e.setAnimationLoop(d),d===null?Ii.stop():Ii.start()},_e.addEventListener("sessionstart",qs),_e.addEventListener("sessionend",ca),this.render=function(d,S){if(S!==void 0&&S.isCamera!==!0){Je("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;B!==null&&B.renderStart(d,S);let C=_e.enabled===!0&&_e.isPresenting===!0,L=P!==null&&(fe===null||C)&&P.begin(I,fe);if(d.matrixWorldAutoUpdate===!0&&d.updateMatrixWorld(),S.parent===null&&S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),_e.enabled===!0&&_e.isPresenting===!0&&(P===null||P.isCompositing()===!1)&&(_e.cameraAutoUpdate===!0&&_e.updateCamera(S),S=_e.getCamera()),d.isScene===!0&&d.onBeforeRender(I,d,S,fe),E=te.get(d,b.length),E.init(S),E.state.textureUnits=je.getTextureUnits(),b.push(E),Ut.multiplyMatrices(S.projectionMatrix,S.matrixWorldInverse),S.isArrayCamera?Vt.setFromArrayCamera(S):at.setFromProjectionMatrix(Ut,jn,S.reversedDepth),on=this.localClippingEnabled,kt=re.init(this.clippingPlanes,on),T=Ie.get(d,x.length),T.init(),x.push(T),this.info.render.frame++,_e.enabled===!0&&_e.isPresenting===!0){let X=I.xr.getDepthSensingMesh();X!==null&&Ys(X,S,-1/0,I.sortObjects)}Ys(d,S,0,I.sortObjects),T.finish(),B!==null&&B.updateLights(E.state.lightsArray),I.sortObjects===!0&&T.sort(Xe,wt),yn=_e.enabled===!1||_e.isPresenting===!1||_e.hasDepthSensing()===!1,yn&&k.addToRenderList(T,d),this.info.autoReset===!0&&this.info.reset(),kt===!0&&re.beginShadows();let U=E.state.shadowsArray;if(Me.render(U,d,S),kt===!0&&re.endShadows(),(L&&P.hasRenderPass())===!1){let X=T.opaque,H=T.transmissive;if(E.setupLights(),S.isArrayCamera){let G=S.cameras;if(H.length>0)for(let Y=0,se=G.length;Y<se;Y++){let Q=G[Y];ha(X,H,d,Q)}yn&&k.render(d);for(let Y=0,se=G.length;Y<se;Y++){let Q=G[Y];Zs(T,d,Q,Q.viewport)}}else H.length>0&&ha(X,H,d,S),yn&&k.render(d),Zs(T,d,S)}fe!==null&&K===0&&(je.updateMultisampleRenderTarget(fe),je.updateRenderTargetMipmap(fe)),L&&P.end(I),d.isScene===!0&&d.onAfterRender(I,d,S),Se.resetDefaultState(),J=-1,ae=null,b.pop(),b.length>0?(E=b[b.length-1],je.setTextureUnits(E.state.textureUnits),kt===!0&&re.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?T=x[x.length-1]:T=null,B!==null&&B.renderEnd()};function Ys(d,S,C,L){if(d.visible===!1)return;if(d.layers.test(S.layers)){if(d.isGroup)C=d.renderOrder;else if(d.isLOD)d.autoUpdate===!0&&d.update(S);else if(d.isLight)E.pushLight(d),d.castShadow&&E.pushShadow(d);else if(d.isSprite){let X=S.isArrayCamera?Vt:at;if(!d.frustumCulled||d.intersectsFrustum(X)){L&&qt.setFromMatrixPosition(d.matrixWorld).applyMatrix4(Ut);let H=ge.update(d),G=d.material;G.visible&&T.push(d,H,G,C,qt.z,null,S)}}else if(d.isMesh||d.isLine||d.isPoints){let X=S.isArrayCamera?Vt:at;if(!d.frustumCulled||d.intersectsFrustum(X)){let H=ge.update(d),G=d.material;if(L&&(d.boundingSphere!==void 0?(d.boundingSphere===null&&d.computeBoundingSphere(),qt.copy(d.boundingSphere.center)):(H.boundingSphere===null&&H.computeBoundingSphere(),qt.copy(H.boundingSphere.center)),qt.applyMatrix4(d.matrixWorld).applyMatrix4(Ut)),Array.isArray(G)){let Y=H.groups;for(let se=0,Q=Y.length;se<Q;se++){let ee=Y[se],ue=G[ee.materialIndex];ue&&ue.visible&&T.push(d,H,ue,C,qt.z,ee,S)}}else G.visible&&T.push(d,H,G,C,qt.z,null,S)}}}let N=d.children;for(let X=0,H=N.length;X<H;X++)Ys(N[X],S,C,L)}function Zs(d,S,C,L){let{opaque:U,transmissive:N,transparent:X}=d;E.setupLightsView(C),kt===!0&&re.setGlobalState(I.clippingPlanes,C),L&&Ce.viewport(ce.copy(L)),U.length>0&&wr(U,S,C),N.length>0&&wr(N,S,C),X.length>0&&wr(X,S,C),Ce.buffers.depth.setTest(!0),Ce.buffers.depth.setMask(!0),Ce.buffers.color.setMask(!0),Ce.setPolygonOffset(!1)}function ha(d,S,C,L){if((C.isScene===!0?C.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[L.id]===void 0){let ee=Ct.has("EXT_color_buffer_half_float")||Ct.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[L.id]=new tn(1,1,{generateMipmaps:!0,type:ee?Jt:Dn,minFilter:Wn,samples:Math.max(4,It.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:st.workingColorSpace})}let N=E.state.transmissionRenderTarget[L.id],X=L.viewport||ce;N.setSize(X.z*I.transmissionResolutionScale,X.w*I.transmissionResolutionScale);let H=I.getRenderTarget(),G=I.getActiveCubeFace(),Y=I.getActiveMipmapLevel();I.setRenderTarget(N),I.getClearColor(ie),Re=I.getClearAlpha(),Re<1&&I.setClearColor(16777215,.5),I.clear(),yn&&k.render(C);let se=I.toneMapping;I.toneMapping=wi;let Q=L.viewport;if(L.viewport!==void 0&&(L.viewport=void 0),E.setupLightsView(L),kt===!0&&re.setGlobalState(I.clippingPlanes,L),wr(d,C,L),je.updateMultisampleRenderTarget(N),je.updateRenderTargetMipmap(N),Ct.has("WEBGL_multisampled_render_to_texture")===!1){let ee=!1;for(let ue=0,de=S.length;ue<de;ue++){let pe=S[ue],{object:Te,geometry:We,material:he,group:Ye}=pe;if(he.side===Nn&&Te.layers.test(L.layers)){let ye=he.side;he.side=un,he.needsUpdate=!0,ua(Te,C,L,We,he,Ye),he.side=ye,he.needsUpdate=!0,ee=!0}}ee===!0&&(je.updateMultisampleRenderTarget(N),je.updateRenderTargetMipmap(N))}I.setRenderTarget(H,G,Y),I.setClearColor(ie,Re),Q!==void 0&&(L.viewport=Q),I.toneMapping=se}function wr(d,S,C){let L=S.isScene===!0?S.overrideMaterial:null;for(let U=0,N=d.length;U<N;U++){let X=d[U],{object:H,geometry:G,group:Y}=X,se=X.material;se.allowOverride===!0&&L!==null&&(se=L),H.layers.test(C.layers)&&ua(H,S,C,G,se,Y)}}function ua(d,S,C,L,U,N){B!==null&&U.isNodeMaterial&&B.setObject(d,U),d.onBeforeRender(I,S,C,L,U,N),d.modelViewMatrix.multiplyMatrices(C.matrixWorldInverse,d.matrixWorld),d.normalMatrix.getNormalMatrix(d.modelViewMatrix),U.onBeforeRender(I,S,C,L,d,N),U.transparent===!0&&U.side===Nn&&U.forceSinglePass===!1?(U.side=un,U.needsUpdate=!0,I.renderBufferDirect(C,S,L,U,d,N),U.side=Qn,U.needsUpdate=!0,I.renderBufferDirect(C,S,L,U,d,N),U.side=Nn):I.renderBufferDirect(C,S,L,U,d,N),d.onAfterRender(I,S,C,L,U,N)}function fa(d){let S=0;for(let C of d)C.texture!==null&&S++;return S}function fi(d,S,C){S.isScene!==!0&&(S=_n);let L=Ge.get(d),U=E.state.lights,N=E.state.shadowsArray,X=U.state.version,H=le.getParameters(d,U.state,N,S,C,E.state.lightProbeGridArray),G=le.getProgramCacheKey(H),Y=L.programs;L.environment=d.isMeshStandardMaterial||d.isMeshLambertMaterial||d.isMeshPhongMaterial?S.environment:null,L.fog=S.fog;let se=d.isMeshStandardMaterial||d.isMeshLambertMaterial&&!d.envMap||d.isMeshPhongMaterial&&!d.envMap;L.envMap=O.get(d.envMap||L.environment,se),L.envMapRotation=L.environment!==null&&d.envMap===null?S.environmentRotation:d.envMapRotation,Y===void 0&&(d.addEventListener("dispose",vt),Y=new Map,L.programs=Y,L.programVariants=new Map);let Q=Y.get(G);if(Q!==void 0){if(L.currentProgram===Q&&L.lightsStateVersion===X)return Ar(d,H),Q}else H.uniforms=le.getUniforms(d),B!==null&&d.isNodeMaterial&&B.build(d,C,H),d.onBeforeCompile(H,I),Q=le.acquireProgram(H,G),Y.set(G,Q),L.uniforms=H.uniforms;let ee=L.uniforms;return(!d.isShaderMaterial&&!d.isRawShaderMaterial||d.clipping===!0)&&(ee.clippingPlanes=re.uniform),Ar(d,H),L.needsLights=Tn(d),L.lightsStateVersion=X,L.needsLights&&(ee.ambientLightColor.value=U.state.ambient,ee.lightProbe.value=U.state.probe,ee.sunLights.value=U.state.sun,ee.sunLightShadows.value=U.state.sunShadow,ee.directionalLights.value=U.state.directional,ee.directionalLightShadows.value=U.state.directionalShadow,ee.spotLights.value=U.state.spot,ee.spotLightShadows.value=U.state.spotShadow,ee.rectAreaLights.value=U.state.rectArea,ee.ltc_1.value=U.state.rectAreaLTC1,ee.ltc_2.value=U.state.rectAreaLTC2,ee.pointLights.value=U.state.point,ee.pointLightShadows.value=U.state.pointShadow,ee.hemisphereLights.value=U.state.hemi,ee.sunShadowMatrix.value=U.state.sunShadowMatrix,ee.sunShadowCascade.value=U.state.sunShadowCascade,ee.directionalShadowMatrix.value=U.state.directionalShadowMatrix,ee.spotLightMatrix.value=U.state.spotLightMatrix,ee.spotLightMap.value=U.state.spotLightMap,ee.pointShadowMatrix.value=U.state.pointShadowMatrix),L.numLightProbeGrids=fa(E.state.lightProbeGridArray),L.currentProgram=Q,L.uniformsList=null,Q}function jr(d,S,C,L,U){let N=Ge.get(d),X=N.currentProgram.id+","+L+","+U,H=N.programVariants.get(X);return H===void 0?(H=fi(d,S,C),N.programVariants.set(X,H)):(N.currentProgram=H,N.uniformsList=null,N.outputColorSpace=L,N.toneMapping=U),H}function da(d){if(d.uniformsList===null){let S=d.currentProgram.getUniforms();d.uniformsList=zs.seqWithValue(S.seq,d.uniforms)}return d.uniformsList}function Ar(d,S){let C=Ge.get(d);C.outputColorSpace=S.outputColorSpace,C.batching=S.batching,C.batchingColor=S.batchingColor,C.instancing=S.instancing,C.instancingColor=S.instancingColor,C.instancingMorph=S.instancingMorph,C.skinning=S.skinning,C.morphTargets=S.morphTargets,C.morphNormals=S.morphNormals,C.morphColors=S.morphColors,C.morphTargetsCount=S.morphTargetsCount,C.numClippingPlanes=S.numClippingPlanes,C.numIntersection=S.numClipIntersection,C.vertexAlphas=S.vertexAlphas,C.vertexTangents=S.vertexTangents,C.toneMapping=S.toneMapping}function pa(d,S,C,L,U){S.isScene!==!0&&(S=_n),je.resetTextureUnits();let N=S.fog,X=L.isMeshStandardMaterial||L.isMeshLambertMaterial||L.isMeshPhongMaterial?S.environment:null,H=fe===null?I.outputColorSpace:fe.isXRRenderTarget===!0?fe.texture.colorSpace:st.workingColorSpace,G=L.isMeshStandardMaterial||L.isMeshLambertMaterial&&!L.envMap||L.isMeshPhongMaterial&&!L.envMap,Y=O.get(L.envMap||X,G),se=L.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,Q=!!C.attributes.tangent&&(!!L.normalMap||L.anisotropy>0),ee=!!C.morphAttributes.position,ue=!!C.morphAttributes.normal,de=!!C.morphAttributes.color,pe=wi;L.toneMapped&&(fe===null||fe.isXRRenderTarget===!0)&&(pe=I.toneMapping);let Te=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,We=Te!==void 0?Te.length:0,he=Ge.get(L),Ye=E.state.lights;if(kt===!0&&(on===!0||d!==ae)){let Ze=d===ae&&L.id===J;re.setState(L,d,Ze)}let ye=!1,Pe=!1;L.version===he.__version?he.needsLights&&he.lightsStateVersion!==Ye.state.version||U.isBatchedMesh&&he.batching===!1||!U.isBatchedMesh&&he.batching===!0||U.isBatchedMesh&&he.batchingColor===!0&&U._colorsTexture===null||U.isBatchedMesh&&he.batchingColor===!1&&U._colorsTexture!==null||U.isInstancedMesh&&he.instancing===!1||!U.isInstancedMesh&&he.instancing===!0||U.isSkinnedMesh&&he.skinning===!1||!U.isSkinnedMesh&&he.skinning===!0||U.isInstancedMesh&&he.instancingColor===!0&&U.instanceColor===null||U.isInstancedMesh&&he.instancingColor===!1&&U.instanceColor!==null||U.isInstancedMesh&&he.instancingMorph===!0&&U.morphTexture===null||U.isInstancedMesh&&he.instancingMorph===!1&&U.morphTexture!==null||he.envMap!==Y||L.fog===!0&&he.fog!==N||he.numClippingPlanes!==void 0&&(he.numClippingPlanes!==re.numPlanes||he.numIntersection!==re.numIntersection)||he.vertexAlphas!==se||he.vertexTangents!==Q||he.morphTargets!==ee||he.morphNormals!==ue||he.morphColors!==de||he.morphTargetsCount!==We||he.numLightProbeGrids!==fa(E.state.lightProbeGridArray)?ye=!0:(he.outputColorSpace!==H||he.toneMapping!==pe)&&(Pe=!0):(ye=!0,he.__version=L.version);let Ne=he.currentProgram;(ye===!0||Pe===!0)&&(Ne=Pe===!0?jr(L,S,U,H,pe):fi(L,S,U),B&&L.isNodeMaterial&&B.onUpdateProgram(L,Ne,he));let gt=!1,nt=!1,qe=!1,Oe=Ne.getUniforms(),lt=he.uniforms;if(Ce.useProgram(Ne.program)&&(gt=!0,nt=!0,qe=!0),L.id!==J&&(J=L.id,nt=!0),gt||ae!==d){Ce.buffers.depth.getReversed()&&d.reversedDepth!==!0&&(d._reversedDepth=!0,d.updateProjectionMatrix()),Oe.setValue(V,"projectionMatrix",d.projectionMatrix),Oe.setValue(V,"viewMatrix",d.matrixWorldInverse);let At=Oe.map.cameraPosition;At!==void 0&&At.setValue(V,Xn.setFromMatrixPosition(d.matrixWorld)),It.logarithmicDepthBuffer&&Oe.setValue(V,"logDepthBufFC",2/(Math.log(d.far+1)/Math.LN2)),(L.isMeshPhongMaterial||L.isMeshToonMaterial||L.isMeshLambertMaterial||L.isMeshBasicMaterial||L.isMeshStandardMaterial||L.isShaderMaterial)&&Oe.setValue(V,"isOrthographic",d.isOrthographicCamera===!0),ae!==d&&(ae=d,nt=!0,qe=!0)}if(he.needsLights&&(Ye.state.sunShadowMap.length>0&&Oe.setValue(V,"sunShadowMap",Ye.state.sunShadowMap,je),Ye.state.directionalShadowMap.length>0&&Oe.setValue(V,"directionalShadowMap",Ye.state.directionalShadowMap,je),Ye.state.spotShadowMap.length>0&&Oe.setValue(V,"spotShadowMap",Ye.state.spotShadowMap,je),Ye.state.pointShadowMap.length>0&&Oe.setValue(V,"pointShadowMap",Ye.state.pointShadowMap,je)),U.isSkinnedMesh){Oe.setOptional(V,U,"bindMatrix"),Oe.setOptional(V,U,"bindMatrixInverse");let Ze=U.skeleton;Ze&&(Ze.boneTexture===null&&Ze.computeBoneTexture(),Oe.setValue(V,"boneTexture",Ze.boneTexture,je))}U.isBatchedMesh&&(Oe.setOptional(V,U,"batchingTexture"),Oe.setValue(V,"batchingTexture",U._matricesTexture,je),Oe.setOptional(V,U,"batchingIdTexture"),Oe.setValue(V,"batchingIdTexture",U._indirectTexture,je),Oe.setOptional(V,U,"batchingColorTexture"),U._colorsTexture!==null&&Oe.setValue(V,"batchingColorTexture",U._colorsTexture,je));let Ot=C.morphAttributes;if((Ot.position!==void 0||Ot.normal!==void 0||Ot.color!==void 0)&&ne.update(U,C,Ne),(nt||he.receiveShadow!==U.receiveShadow)&&(he.receiveShadow=U.receiveShadow,Oe.setValue(V,"receiveShadow",U.receiveShadow)),(L.isMeshStandardMaterial||L.isMeshLambertMaterial||L.isMeshPhongMaterial)&&L.envMap===null&&S.environment!==null&&(lt.envMapIntensity.value=S.environmentIntensity),lt.dfgLUT!==void 0&&(lt.dfgLUT.value=rS()),nt){if(Oe.setValue(V,"toneMappingExposure",I.toneMappingExposure),he.needsLights&&an(lt,qe),N&&L.fog===!0&&be.refreshFogUniforms(lt,N),be.refreshMaterialUniforms(lt,L,me,ze,E.state.transmissionRenderTarget[d.id]),he.needsLights&&he.numLightProbeGrids>0){let Ze=w,At=0;for(let fn of E.state.lightProbeGridArray)fn.texture!==null&&(Ze.textures[At]=fn.texture,Ze.min[At]=fn.boundingBox.min,Ze.max[At]=fn.boundingBox.max,Ze.resolution[At]=fn.resolution,At++);for(let fn in Ze)Ze[fn].length=At;lt.probesSH.value=Ze.textures,lt.probesMin.value=Ze.min,lt.probesMax.value=Ze.max,lt.probesResolution.value=Ze.resolution}zs.upload(V,da(he),lt,je)}if(L.isShaderMaterial&&L.uniformsNeedUpdate===!0&&(zs.upload(V,da(he),lt,je),L.uniformsNeedUpdate=!1),L.isSpriteMaterial&&Oe.setValue(V,"center",U.center),Oe.setValue(V,"modelViewMatrix",U.modelViewMatrix),Oe.setValue(V,"normalMatrix",U.normalMatrix),Oe.setValue(V,"modelMatrix",U.matrixWorld),L.uniformsGroups!==void 0){let Ze=L.uniformsGroups;for(let At=0,fn=Ze.length;At<fn;At++){let or=Ze[At];Be.update(or,Ne),Be.bind(or,Ne)}}return Ne}function an(d,S){d.ambientLightColor.needsUpdate=S,d.lightProbe.needsUpdate=S,d.sunLights.needsUpdate=S,d.sunLightShadows.needsUpdate=S,d.directionalLights.needsUpdate=S,d.directionalLightShadows.needsUpdate=S,d.pointLights.needsUpdate=S,d.pointLightShadows.needsUpdate=S,d.spotLights.needsUpdate=S,d.spotLightShadows.needsUpdate=S,d.rectAreaLights.needsUpdate=S,d.hemisphereLights.needsUpdate=S}function Tn(d){return d.isMeshLambertMaterial||d.isMeshToonMaterial||d.isMeshPhongMaterial||d.isMeshStandardMaterial||d.isShadowMaterial||d.isShaderMaterial&&d.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return K},this.getRenderTarget=function(){return fe},this.setRenderTargetTextures=function(d,S,C){let L=Ge.get(d);L.__autoAllocateDepthBuffer=d.resolveDepthBuffer===!1,L.__autoAllocateDepthBuffer===!1&&(L.__useRenderToTexture=!1),Ge.get(d.texture).__webglTexture=S,Ge.get(d.depthTexture).__webglTexture=L.__autoAllocateDepthBuffer?void 0:C,L.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(d,S){let C=Ge.get(d);C.__webglFramebuffer=S,C.__useDefaultFramebuffer=S===void 0},this.setRenderTarget=function(d,S=0,C=0){fe=d,q=S,K=C;let L=null,U=!1,N=!1;if(d){let H=Ge.get(d);if(H.__useDefaultFramebuffer!==void 0){Ce.bindFramebuffer(V.FRAMEBUFFER,H.__webglFramebuffer),ce.copy(d.viewport),we.copy(d.scissor),De=d.scissorTest,Ce.viewport(ce),Ce.scissor(we),Ce.setScissorTest(De),J=-1;return}else if(H.__webglFramebuffer===void 0)je.setupRenderTarget(d);else if(H.__hasExternalTextures)je.rebindTextures(d,Ge.get(d.texture).__webglTexture,Ge.get(d.depthTexture).__webglTexture);else if(d.depthBuffer){let se=d.depthTexture;if(H.__boundDepthTexture!==se){if(se!==null&&Ge.has(se)&&(d.width!==se.image.width||d.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(d)}}let G=d.texture;(G.isData3DTexture||G.isDataArrayTexture||G.isCompressedArrayTexture)&&(N=!0);let Y=Ge.get(d).__webglFramebuffer;d.isWebGLCubeRenderTarget?(Array.isArray(Y[S])?L=Y[S][C]:L=Y[S],U=!0):d.samples>0&&je.useMultisampledRTT(d)===!1?L=Ge.get(d).__webglMultisampledFramebuffer:Array.isArray(Y)?L=Y[C]:L=Y,ce.copy(d.viewport),we.copy(d.scissor),De=d.scissorTest}else ce.copy(Ve).multiplyScalar(me).floor(),we.copy(ft).multiplyScalar(me).floor(),De=mt;if(C!==0&&(L=z),Ce.bindFramebuffer(V.FRAMEBUFFER,L)&&Ce.drawBuffers(d,L),Ce.viewport(ce),Ce.scissor(we),Ce.setScissorTest(De),U){let H=Ge.get(d.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+S,H.__webglTexture,C)}else if(N){let H=S;for(let G=0;G<d.textures.length;G++){let Y=Ge.get(d.textures[G]);V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0+G,Y.__webglTexture,C,H)}}else if(d!==null&&C!==0){let H=Ge.get(d.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,H.__webglTexture,C)}J=-1};function _(d){let S=Ge.get(d);return(S.__readFormat!==d.format||S.__readType!==d.type)&&(S.__readFormat=d.format,S.__readType=d.type,S.__formatReadable=It.textureFormatReadable(d.format),S.__typeReadable=It.textureTypeReadable(d.type)),S}this.readRenderTargetPixels=function(d,S,C,L,U,N,X,H=0){if(!(d&&d.isWebGLRenderTarget)){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let G=Ge.get(d).__webglFramebuffer;if(d.isWebGLCubeRenderTarget&&X!==void 0&&(G=G[X],Array.isArray(G)&&(G=G[0])),G){Ce.bindFramebuffer(V.FRAMEBUFFER,G);try{let Y=d.textures[H],se=Y.format,Q=Y.type;d.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+H);let ee=_(Y);if(ee.__formatReadable===!1){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ee.__typeReadable===!1){Je("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}S>=0&&S<=d.width-L&&C>=0&&C<=d.height-U&&V.readPixels(S,C,L,U,ve.convert(se),ve.convert(Q),N)}finally{let Y=fe!==null?Ge.get(fe).__webglFramebuffer:null;Ce.bindFramebuffer(V.FRAMEBUFFER,Y)}}},this.readRenderTargetPixelsAsync=async function(d,S,C,L,U,N,X,H=0){if(!(d&&d.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let G=Ge.get(d).__webglFramebuffer;if(d.isWebGLCubeRenderTarget&&X!==void 0&&(G=G[X],Array.isArray(G)&&(G=G[0])),G)if(S>=0&&S<=d.width-L&&C>=0&&C<=d.height-U){Ce.bindFramebuffer(V.FRAMEBUFFER,G);let Y=d.textures[H],se=Y.format,Q=Y.type;d.textures.length>1&&V.readBuffer(V.COLOR_ATTACHMENT0+H);let ee=_(Y);if(ee.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ee.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ue=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,ue),V.bufferData(V.PIXEL_PACK_BUFFER,N.byteLength,V.STREAM_READ),V.readPixels(S,C,L,U,ve.convert(se),ve.convert(Q),0),V.bindBuffer(V.PIXEL_PACK_BUFFER,null);let de=fe!==null?Ge.get(fe).__webglFramebuffer:null;Ce.bindFramebuffer(V.FRAMEBUFFER,de);let pe=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await fm(V,pe,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,ue),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,N),V.bindBuffer(V.PIXEL_PACK_BUFFER,null),V.deleteBuffer(ue),V.deleteSync(pe),N}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(d,S=null,C=0){let L=Math.pow(2,-C),U=Math.floor(d.image.width*L),N=Math.floor(d.image.height*L),X=S!==null?S.x:0,H=S!==null?S.y:0;je.setTexture2D(d,0),V.copyTexSubImage2D(V.TEXTURE_2D,C,0,0,X,H,U,N),Ce.unbindTexture()},this.copyTextureToTexture=function(d,S,C=null,L=null,U=0,N=0){let X,H,G,Y,se,Q,ee,ue,de,pe=d.isCompressedTexture?d.mipmaps[N]:d.image;if(C!==null)X=C.max.x-C.min.x,H=C.max.y-C.min.y,G=C.isBox3?C.max.z-C.min.z:1,Y=C.min.x,se=C.min.y,Q=C.isBox3?C.min.z:0;else{let Oe=Math.pow(2,-U);X=Math.floor(pe.width*Oe),H=Math.floor(pe.height*Oe),d.isDataArrayTexture?G=pe.depth:d.isData3DTexture?G=Math.floor(pe.depth*Oe):G=1,Y=0,se=0,Q=0}L!==null?(ee=L.x,ue=L.y,de=L.z):(ee=0,ue=0,de=0);let Te=ve.convert(S.format),We=ve.convert(S.type),he;S.isData3DTexture?(je.setTexture3D(S,0),he=V.TEXTURE_3D):S.isDataArrayTexture||S.isCompressedArrayTexture?(je.setTexture2DArray(S,0),he=V.TEXTURE_2D_ARRAY):(je.setTexture2D(S,0),he=V.TEXTURE_2D),Ce.activeTexture(V.TEXTURE0),Ce.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,S.flipY),Ce.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),Ce.pixelStorei(V.UNPACK_ALIGNMENT,S.unpackAlignment);let Ye=Ce.getParameter(V.UNPACK_ROW_LENGTH),ye=Ce.getParameter(V.UNPACK_IMAGE_HEIGHT),Pe=Ce.getParameter(V.UNPACK_SKIP_PIXELS),Ne=Ce.getParameter(V.UNPACK_SKIP_ROWS),gt=Ce.getParameter(V.UNPACK_SKIP_IMAGES);Ce.pixelStorei(V.UNPACK_ROW_LENGTH,pe.width),Ce.pixelStorei(V.UNPACK_IMAGE_HEIGHT,pe.height),Ce.pixelStorei(V.UNPACK_SKIP_PIXELS,Y),Ce.pixelStorei(V.UNPACK_SKIP_ROWS,se),Ce.pixelStorei(V.UNPACK_SKIP_IMAGES,Q);let nt=d.isDataArrayTexture||d.isData3DTexture,qe=S.isDataArrayTexture||S.isData3DTexture;if(d.isDepthTexture){let Oe=Ge.get(d),lt=Ge.get(S),Ot=Ge.get(Oe.__renderTarget),Ze=Ge.get(lt.__renderTarget);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,Ot.__webglFramebuffer),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,Ze.__webglFramebuffer);for(let At=0;At<G;At++)nt&&(V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ge.get(d).__webglTexture,U,Q+At),V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Ge.get(S).__webglTexture,N,de+At)),V.blitFramebuffer(Y,se,Y+X,se+H,ee,ue,ee+X,ue+H,V.DEPTH_BUFFER_BIT,V.NEAREST);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else if(U!==0||d.isRenderTargetTexture||Ge.has(d)){let Oe=Ge.get(d),lt=Ge.get(S);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,D),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,$);for(let Ot=0;Ot<G;Ot++)nt?V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Oe.__webglTexture,U,Q+Ot):V.framebufferTexture2D(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,Oe.__webglTexture,U),qe?V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,lt.__webglTexture,N,de+Ot):V.framebufferTexture2D(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_2D,lt.__webglTexture,N),U!==0?V.blitFramebuffer(Y,se,Y+X,se+H,ee,ue,ee+X,ue+H,V.COLOR_BUFFER_BIT,V.NEAREST):qe?V.copyTexSubImage3D(he,N,ee,ue,de+Ot,Y,se,X,H):V.copyTexSubImage2D(he,N,ee,ue,Y,se,X,H);Ce.bindFramebuffer(V.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else qe?d.isDataTexture||d.isData3DTexture?V.texSubImage3D(he,N,ee,ue,de,X,H,G,Te,We,pe.data):S.isCompressedArrayTexture?V.compressedTexSubImage3D(he,N,ee,ue,de,X,H,G,Te,pe.data):V.texSubImage3D(he,N,ee,ue,de,X,H,G,Te,We,pe):d.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,N,ee,ue,X,H,Te,We,pe.data):d.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,N,ee,ue,pe.width,pe.height,Te,pe.data):V.texSubImage2D(V.TEXTURE_2D,N,ee,ue,X,H,Te,We,pe);Ce.pixelStorei(V.UNPACK_ROW_LENGTH,Ye),Ce.pixelStorei(V.UNPACK_IMAGE_HEIGHT,ye),Ce.pixelStorei(V.UNPACK_SKIP_PIXELS,Pe),Ce.pixelStorei(V.UNPACK_SKIP_ROWS,Ne),Ce.pixelStorei(V.UNPACK_SKIP_IMAGES,gt),N===0&&S.generateMipmaps===!0&&S.mipmapsAutoUpdate===!0&&V.generateMipmap(he),Ce.unbindTexture()},this.initRenderTarget=function(d){Ge.get(d).__webglFramebuffer===void 0&&je.setupRenderTarget(d)},this.initTexture=function(d){d.isCubeTexture?je.setTextureCube(d,0):d.isData3DTexture?je.setTexture3D(d,0):d.isDataArrayTexture||d.isCompressedArrayTexture?je.setTexture2DArray(d,0):je.setTexture2D(d,0),Ce.unbindTexture()},this.resetState=function(){q=0,K=0,fe=null,Ce.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return jn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=st._getDrawingBufferColorSpace(e),t.unpackColorSpace=st._getUnpackColorSpace()}};var hi=new $e,Cc=class extends Gn{constructor(e){super(e),this.propertyNameMapping={},this.customPropertyMapping={}}load(e,t,n,r){let s=this,o=new Qi(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(s.parse(a))}catch(l){r?r(l):console.error(l),s.manager.itemError(e)}},n,r)}setPropertyNameMapping(e){this.propertyNameMapping=e}setCustomPropertyNameMapping(e){this.customPropertyMapping=e}parse(e){function t(M,w=0){let T=/^ply([\s\S]*)end_header(\r\n|\r|\n)/,E="",x=T.exec(M);x!==null&&(E=x[1]);let b={comments:[],elements:[],headerLength:w,objInfo:""},P=E.split(/\r\n|\r|\n/),I;function F(B,z){let D={type:B[0]};return D.type==="list"?(D.name=B[3],D.countType=B[1],D.itemType=B[2]):D.name=B[1],D.name in z&&(D.name=z[D.name]),D}for(let B=0;B<P.length;B++){let z=P[B];if(z=z.trim(),z==="")continue;let D=z.split(/\s+/),$=D.shift();switch(z=D.join(" "),$){case"format":b.format=D[0],b.version=D[1];break;case"comment":b.comments.push(z);break;case"element":I!==void 0&&b.elements.push(I),I={},I.name=D[0],I.count=parseInt(D[1]),I.properties=[];break;case"property":I.properties.push(F(D,A.propertyNameMapping));break;case"obj_info":b.objInfo=z;break;default:console.log("unhandled",$,D)}}return I!==void 0&&b.elements.push(I),b}function n(M,w){switch(w){case"char":case"uchar":case"short":case"ushort":case"int":case"uint":case"int8":case"uint8":case"int16":case"uint16":case"int32":case"uint32":return parseInt(M);case"float":case"double":case"float32":case"float64":return parseFloat(M)}}function r(M,w){let T={};for(let E=0;E<M.length;E++){if(w.empty())return null;if(M[E].type==="list"){let x=[],b=n(w.next(),M[E].countType);for(let P=0;P<b;P++){if(w.empty())return null;x.push(n(w.next(),M[E].itemType))}T[M[E].name]=x}else T[M[E].name]=n(w.next(),M[E].type)}return T}function s(){let M={indices:[],vertices:[],normals:[],uvs:[],faceVertexUvs:[],colors:[],faceVertexColors:[],descriptors:{}};for(let w of Object.keys(A.customPropertyMapping))M[w]=[];return M}function o(M){switch(M){case"int8":case"char":return Mo;case"uint8":case"uchar":return So;case"int16":case"short":return wo;case"uint16":case"ushort":return Or;case"int32":case"int":return Ao;case"uint32":case"uint":return Br;case"float32":case"float":return zt;case"float64":case"double":return Yu}}function a(M){switch(M){case"uchar":case"uint8":return 1/255;case"ushort":case"uint16":return 1/65535;case"float":case"float32":case"double":case"float64":return 1;default:return 1/255}}function l(M){return M==="float"||M==="float32"||M==="double"||M==="float64"}function c(M){function w(fe){for(let J of fe){let ae=M.find(ce=>ce.name===J);if(ae)return ae}return null}let T=w(["x","px","posx"]),E=w(["y","py","posy"]),x=w(["z","pz","posz"]),b=w(["nx","normalx"]),P=w(["ny","normaly"]),I=w(["nz","normalz"]),F=w(["s","u","texture_u","tx"]),B=w(["t","v","texture_v","ty"]),z=w(["red","diffuse_red","r","diffuse_r"]),D=w(["green","diffuse_green","g","diffuse_g"]),$=w(["blue","diffuse_blue","b","diffuse_b"]),q=w(["texcoord"]),K={};for(let fe of Object.keys(A.customPropertyMapping)){let ae=A.customPropertyMapping[fe].map(De=>M.find(ie=>ie.name===De)),ce=ae.filter(De=>De).map(De=>De.type),we=ce.length>0&&ce.every(De=>De===ce[0]);K[fe]={type:we?ce[0]:"float32",usage:ae.every(De=>De!==void 0)}}return{position:{names:[T?T.name:"x",E?E.name:"y",x?x.name:"z"],type:T?T.type:"float32",usage:!!(T&&E&&x)},normal:{names:[b?b.name:"nx",P?P.name:"ny",I?I.name:"nz"],type:b?b.type:"float32",usage:!!(b&&P&&I)},uv:{names:[F?F.name:"s",B?B.name:"t"],type:F?F.type:"float32",usage:!!(F&&B)},texcoord:{type:q?q.itemType:"float32",usage:!!q},color:{names:[z?z.name:"red",D?D.name:"green",$?$.name:"blue"],type:z?z.type:"uchar",usage:!!(z&&D&&$)},custom:K}}function h(M,w){let T=s(),E=/end_header\s+(\S[\s\S]*\S|\S)\s*$/,x,b;(b=E.exec(M))!==null?x=b[1].split(/\s+/):x=[];let P=new Zu(x);e:for(let I=0;I<w.elements.length;I++){let F=w.elements[I],B=c(F.properties);T.descriptors[F.name]=B;for(let z=0;z<F.count;z++){let D=r(F.properties,P);if(!D)break e;f(T,F.name,D,B)}}return u(T)}function u(M){let w=new Nt,T=M.descriptors.vertex;M.indices.length>0&&w.setIndex(M.indices);let E=o(T?T.position.type:"float32");if(w.setAttribute("position",new E(M.vertices,3)),M.normals.length>0){let x=o(T.normal.type);w.setAttribute("normal",new x(M.normals,3))}if(M.uvs.length>0){let x=o(T.uv.type);w.setAttribute("uv",new x(M.uvs,2))}if(M.colors.length>0){let x=T.color.type,b=!l(x),P=o(x);w.setAttribute("color",new P(M.colors,3,b))}for(let x of Object.keys(A.customPropertyMapping))if(M[x].length>0){let b=o(T.custom[x].type);w.setAttribute(x,new b(M[x],A.customPropertyMapping[x].length))}if(M.faceVertexUvs.length>0||M.faceVertexColors.length>0){if(w=w.toNonIndexed(),M.faceVertexUvs.length>0){let x=o(M.descriptors.face.texcoord.type);w.setAttribute("uv",new x(M.faceVertexUvs,2))}if(M.faceVertexColors.length>0){let x=M.descriptors.face.color.type,b=!l(x),P=o(x);w.setAttribute("color",new P(M.faceVertexColors,3,b))}}return w.computeBoundingSphere(),w}function f(M,w,T,E){if(w==="vertex"){let{position:x,normal:b,uv:P,color:I}=E;if(x.usage&&M.vertices.push(T[x.names[0]],T[x.names[1]],T[x.names[2]]),b.usage&&M.normals.push(T[b.names[0]],T[b.names[1]],T[b.names[2]]),P.usage&&M.uvs.push(T[P.names[0]],T[P.names[1]]),I.usage){let F=a(I.type),B=l(I.type);hi.setRGB(T[I.names[0]]*F,T[I.names[1]]*F,T[I.names[2]]*F,Xt);let z=1/F;M.colors.push(B?hi.r:Math.round(hi.r*z),B?hi.g:Math.round(hi.g*z),B?hi.b:Math.round(hi.b*z))}for(let F of Object.keys(A.customPropertyMapping))for(let B of A.customPropertyMapping[F])M[F].push(T[B])}else if(w==="face"){let x=T.vertex_indices||T.vertex_index,b=T.texcoord;x.length===3?(M.indices.push(x[0],x[1],x[2]),b&&b.length===6&&(M.faceVertexUvs.push(b[0],b[1]),M.faceVertexUvs.push(b[2],b[3]),M.faceVertexUvs.push(b[4],b[5]))):x.length===4&&(M.indices.push(x[0],x[1],x[2]),M.indices.push(x[0],x[2],x[3]),b&&b.length===8&&(M.faceVertexUvs.push(b[0],b[1]),M.faceVertexUvs.push(b[2],b[3]),M.faceVertexUvs.push(b[4],b[5]),M.faceVertexUvs.push(b[0],b[1]),M.faceVertexUvs.push(b[4],b[5]),M.faceVertexUvs.push(b[6],b[7])));let{color:P}=E;if(P.usage){let I=a(P.type);hi.setRGB(T[P.names[0]]*I,T[P.names[1]]*I,T[P.names[2]]*I,Xt);let F=1/I,B=hi.r*F,z=hi.g*F,D=hi.b*F;M.faceVertexColors.push(B,z,D),M.faceVertexColors.push(B,z,D),M.faceVertexColors.push(B,z,D),x.length===4&&(M.faceVertexColors.push(B,z,D),M.faceVertexColors.push(B,z,D),M.faceVertexColors.push(B,z,D))}}}function p(M,w){let T={},E=0;for(let x=0;x<w.length;x++){let b=w[x],P=b.valueReader;if(b.type==="list"){let I=[],F=b.countReader.read(M+E);E+=b.countReader.size;for(let B=0;B<F;B++)I.push(P.read(M+E)),E+=P.size;T[b.name]=I}else T[b.name]=P.read(M+E),E+=P.size}return[T,E]}function v(M,w,T){function E(x,b,P){switch(b){case"int8":case"char":return{read:I=>x.getInt8(I),size:1};case"uint8":case"uchar":return{read:I=>x.getUint8(I),size:1};case"int16":case"short":return{read:I=>x.getInt16(I,P),size:2};case"uint16":case"ushort":return{read:I=>x.getUint16(I,P),size:2};case"int32":case"int":return{read:I=>x.getInt32(I,P),size:4};case"uint32":case"uint":return{read:I=>x.getUint32(I,P),size:4};case"float32":case"float":return{read:I=>x.getFloat32(I,P),size:4};case"float64":case"double":return{read:I=>x.getFloat64(I,P),size:8}}}for(let x=0,b=M.length;x<b;x++){let P=M[x];P.type==="list"?(P.countReader=E(w,P.countType,T),P.valueReader=E(w,P.itemType,T)):P.valueReader=E(w,P.type,T)}}function y(M,w){let T=s(),E=w.format==="binary_little_endian",x=new DataView(M,w.headerLength),b,P=0;for(let I=0;I<w.elements.length;I++){let F=w.elements[I],B=F.properties,z=c(B);T.descriptors[F.name]=z,v(B,x,E);for(let D=0;D<F.count;D++){b=p(P,B),P+=b[1];let $=b[0];f(T,F.name,$,z)}}return u(T)}function m(M){let w=0,T=!0,E="",x=[],b=new TextDecoder().decode(M.subarray(0,5)),P=/^ply\r\n/.test(b);do{let I=String.fromCharCode(M[w++]);I!==`
`&&I!=="\r"?E+=I:(E==="end_header"&&(T=!1),E!==""&&(x.push(E),E=""))}while(T&&w<M.length);return P===!0&&w++,{headerText:x.join("\r")+"\r",headerLength:w}}let g,A=this;if(e instanceof ArrayBuffer){let M=new Uint8Array(e),{headerText:w,headerLength:T}=m(M),E=t(w,T);if(E.format==="ascii"){let x=new TextDecoder().decode(M);g=h(x,E)}else g=y(e,E)}else g=h(e,t(e));return g}},Yu=class extends ht{constructor(e,t,n){super(new Float64Array(e),t,n)}},Zu=class{constructor(e){this.arr=e,this.i=0}empty(){return this.i>=this.arr.length}next(){return this.arr[this.i++]}};function Jm(i,e=1e-4){e=Math.max(e,Number.EPSILON);let t={},n=i.getIndex(),r=i.getAttribute("position"),s=n?n.count:r.count,o=0,a=Object.keys(i.attributes),l=[],c=new Map,h=[],u=["getX","getY","getZ","getW"],f=e*.5,p=Math.log10(1/e),v=Math.pow(10,p),y=f*v;for(let g=0;g<s;g++){let A=n?n.getX(g):g,M="";for(let w=0,T=a.length;w<T;w++){let E=a[w],x=i.getAttribute(E),b=x.itemSize;for(let P=0;P<b;P++)M+=`${Math.trunc(x[u[P]](A)*v+y)},`}M in t?h.push(t[M]):(l.push(A),t[M]=o,h.push(o),o++)}let m=i.clone();for(let g in i.attributes)m.setAttribute(g,Km(i.attributes[g],l,c));for(let g in i.morphAttributes)m.morphAttributes[g]=i.morphAttributes[g].map(A=>Km(A,l,c));return m.setIndex(h),m}function Ku(i,e){if(e===Au)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===ks||e===Qo){let t=i.getIndex();if(t===null){let s=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)s.push(a);i.setIndex(s),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,r=[];if(e===ks)for(let s=1;s<=n;s++)r.push(t.getX(0)),r.push(t.getX(s)),r.push(t.getX(s+1));else for(let s=0;s<n;s++)s%2===0?(r.push(t.getX(s)),r.push(t.getX(s+1)),r.push(t.getX(s+2))):(r.push(t.getX(s+2)),r.push(t.getX(s+1)),r.push(t.getX(s)));return r.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(r),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function Km(i,e,t=new Map){let n=i.isInterleavedBufferAttribute,r=n?i.data:i,s=n?r.stride:i.itemSize,o=n?t.get(r):void 0;if(o===void 0){let l=new r.array.constructor(e.length*s);for(let c=0;c<e.length;c++)for(let h=0;h<s;h++)l[c*s+h]=r.array[e[c]*s+h];o=n?new r.constructor(l,s,r.meshPerAttribute):new i.constructor(l,i.itemSize,i.normalized,i.meshPerAttribute),o.setUsage(r.usage),n&&t.set(r,o)}let a=n?new i.constructor(o,i.itemSize,i.offset,i.normalized):o;return a.name=i.name,n||(a.gpuType=i.gpuType),a}function jm(i){let e=new Map,t=new Map,n=i.clone();return Qm(i,n,function(r,s){e.set(s,r),t.set(r,s)}),n.traverse(function(r){if(!r.isSkinnedMesh)return;let s=r,o=e.get(r),a=o.skeleton.bones;s.skeleton=o.skeleton.clone(),s.bindMatrix.copy(o.bindMatrix),s.skeleton.bones=a.map(function(l){return t.get(l)}),s.bind(s.skeleton,s.bindMatrix)}),n}function Qm(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)Qm(i.children[n],e.children[n],t)}var Ic=class extends Gn{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new rf(t)}),this.register(function(t){return new sf(t)}),this.register(function(t){return new of(t)}),this.register(function(t){return new mf(t)}),this.register(function(t){return new gf(t)}),this.register(function(t){return new vf(t)}),this.register(function(t){return new lf(t)}),this.register(function(t){return new cf(t)}),this.register(function(t){return new hf(t)}),this.register(function(t){return new uf(t)}),this.register(function(t){return new nf(t)}),this.register(function(t){return new ff(t)}),this.register(function(t){return new af(t)}),this.register(function(t){return new pf(t)}),this.register(function(t){return new df(t)}),this.register(function(t){return new ef(t)}),this.register(function(t){return new Pc(t,ot.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new Pc(t,ot.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new _f(t)})}load(e,t,n,r){let s=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let c=er.extractUrlBase(e);o=er.resolveURL(c,this.path)}else o=er.extractUrlBase(e);this.manager.itemStart(e);let a=function(c){r?r(c):console.error(c),s.manager.itemError(e),s.manager.itemEnd(e)},l=new Qi(this.manager);l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.path),l.setResponseType("arraybuffer"),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials),l.load(e,function(c){try{s.parse(c,o,function(h){t(h),s.manager.itemEnd(e)},a)}catch(h){a(h)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,r){let s,o={},a={},l=new TextDecoder;if(typeof e=="string")s=JSON.parse(e);else if(e instanceof ArrayBuffer)if(l.decode(new Uint8Array(e,0,4))===rg){try{o[ot.KHR_BINARY_GLTF]=new yf(e)}catch(u){r&&r(u);return}s=JSON.parse(o[ot.KHR_BINARY_GLTF].content)}else s=JSON.parse(l.decode(e));else s=e;if(s.asset===void 0||s.asset.version[0]<2){r&&r(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let c=new Tf(s,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});c.fileLoader.setRequestHeader(this.requestHeader);for(let h=0;h<this.pluginCallbacks.length;h++){let u=this.pluginCallbacks[h](c);u.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[u.name]=u,o[u.name]=!0}if(s.extensionsUsed)for(let h=0;h<s.extensionsUsed.length;++h){let u=s.extensionsUsed[h],f=s.extensionsRequired||[];switch(u){case ot.KHR_MATERIALS_UNLIT:o[u]=new tf;break;case ot.KHR_DRACO_MESH_COMPRESSION:o[u]=new xf(s,this.dracoLoader);break;case ot.KHR_TEXTURE_TRANSFORM:o[u]=new bf;break;case ot.KHR_MESH_QUANTIZATION:o[u]=new Mf;break;default:f.indexOf(u)>=0&&a[u]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+u+'".')}}c.setExtensions(o),c.setPlugins(a),c.parse(n,r)}parseAsync(e,t){let n=this;return new Promise(function(r,s){n.parse(e,t,r,s)})}};function sS(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function Gt(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var ot={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},ef=class{constructor(e){this.parser=e,this.name=ot.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,r=t.length;n<r;n++){let s=t[n];s.extensions&&s.extensions[this.name]&&s.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,s.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,r=t.cache.get(n);if(r)return r;let s=t.json,l=((s.extensions&&s.extensions[this.name]||{}).lights||[])[e],c,h=new $e(16777215);l.color!==void 0&&h.setRGB(l.color[0],l.color[1],l.color[2],Lt);let u=l.range!==void 0?l.range:0;switch(l.type){case"directional":c=new Ho(h),c.target.position.set(0,0,-1),c.add(c.target);break;case"point":c=new zo(h),c.distance=u;break;case"spot":c=new ko(h),c.distance=u,l.spot=l.spot||{},l.spot.innerConeAngle=l.spot.innerConeAngle!==void 0?l.spot.innerConeAngle:0,l.spot.outerConeAngle=l.spot.outerConeAngle!==void 0?l.spot.outerConeAngle:Math.PI/4,c.angle=l.spot.outerConeAngle,c.penumbra=1-l.spot.innerConeAngle/l.spot.outerConeAngle,c.target.position.set(0,0,-1),c.add(c.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+l.type)}return c.position.set(0,0,0),Ri(c,l),l.intensity!==void 0&&(c.intensity=l.intensity),c.name=t.createUniqueName(l.name||"light_"+e),r=Promise.resolve(c),t.cache.add(n,r),r}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,s=n.json.nodes[e],a=(s.extensions&&s.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(l){return n._getNodeRef(t.cache,a,l)})}},tf=class{constructor(){this.name=ot.KHR_MATERIALS_UNLIT}getMaterialType(){return ai}extendParams(e,t,n){let r=[];e.color=new $e(1,1,1),e.opacity=1;let s=t.pbrMetallicRoughness;if(s){if(Array.isArray(s.baseColorFactor)){let o=s.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],Lt),e.opacity=o[3]}s.baseColorTexture!==void 0&&r.push(n.assignTexture(e,"map",s.baseColorTexture,Xt))}return Promise.all(r)}},nf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},rf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&r.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&r.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(r.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let s=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new it(s,s)}return Promise.all(r)}},sf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&r.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(r)}},of=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_DISPERSION}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},af=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&r.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&r.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(r)}},lf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_SHEEN}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];if(t.sheenColor=new $e(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let s=n.sheenColorFactor;t.sheenColor.setRGB(s[0],s[1],s[2],Lt)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&r.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,Xt)),n.sheenRoughnessTexture!==void 0&&r.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(r)}},cf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&r.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(r)}},hf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_VOLUME}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&r.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let s=n.attenuationColor||[1,1,1];return t.attenuationColor=new $e().setRGB(s[0],s[1],s[2],Lt),Promise.all(r)}},uf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_IOR}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},ff=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_SPECULAR}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&r.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let s=n.specularColorFactor||[1,1,1];return t.specularColor=new $e().setRGB(s[0],s[1],s[2],Lt),n.specularColorTexture!==void 0&&r.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,Xt)),Promise.all(r)}},df=class{constructor(e){this.parser=e,this.name=ot.EXT_MATERIALS_BUMP}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&r.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(r)}},pf=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return Gt(this.parser,e,this.name)!==null?wn:null}extendMaterialParams(e,t){let n=Gt(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&r.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(r)}},mf=class{constructor(e){this.parser=e,this.name=ot.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,r=n.textures[e];if(!r.extensions||!r.extensions[this.name])return null;let s=r.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,s.source,o)}},gf=class{constructor(e){this.parser=e,this.name=ot.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,r=n.json,s=r.textures[e];if(!s.extensions||!s.extensions[t])return null;let o=s.extensions[t],a=r.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},vf=class{constructor(e){this.parser=e,this.name=ot.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,r=n.json,s=r.textures[e];if(!s.extensions||!s.extensions[t])return null;let o=s.extensions[t],a=r.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},Pc=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let r=n.extensions[this.name],s=this.parser.getDependency("buffer",r.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return s.then(function(a){let l=r.byteOffset||0,c=r.byteLength||0,h=r.count,u=r.byteStride,f=new Uint8Array(a,l,c);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(h,u,f,r.mode,r.filter).then(function(p){return p.buffer}):o.ready.then(function(){let p=new ArrayBuffer(h*u);return o.decodeGltfBuffer(new Uint8Array(p),h,u,f,r.mode,r.filter),p})})}else return null}},_f=class{constructor(e){this.name=ot.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let r=t.meshes[n.mesh];for(let c of r.primitives)if(c.mode!==ei.TRIANGLES&&c.mode!==ei.TRIANGLE_STRIP&&c.mode!==ei.TRIANGLE_FAN&&c.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],l={};for(let c in o)a.push(this.parser.getDependency("accessor",o[c]).then(h=>(l[c]=h,l[c])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(c=>{let h=c.pop(),u=h.isGroup?h.children:[h],f=c[0].count,p=[];for(let v of u){let y=new et,m=new W,g=new zn,A=new W(1,1,1),M=new Ro(v.geometry,v.material,f);for(let T=0;T<f;T++)l.TRANSLATION&&m.fromBufferAttribute(l.TRANSLATION,T),l.ROTATION&&g.fromBufferAttribute(l.ROTATION,T),l.SCALE&&A.fromBufferAttribute(l.SCALE,T),M.setMatrixAt(T,y.compose(m,g,A));let w=null;for(let T in l)if(T==="_COLOR_0"){let E=l[T];M.instanceColor=new Xi(E.array,E.itemSize,E.normalized)}else if(T!=="TRANSLATION"&&T!=="ROTATION"&&T!=="SCALE"){if(w===null){let x=M.geometry;w=new Nt,w.name=x.name;for(let b in x.attributes)w.setAttribute(b,x.attributes[b]);for(let b in x.morphAttributes)w.morphAttributes[b]=x.morphAttributes[b];x.index!==null&&w.setIndex(x.index),w.morphTargetsRelative=x.morphTargetsRelative;for(let b of x.groups)w.addGroup(b.start,b.count,b.materialIndex);x.boundingBox!==null&&(w.boundingBox=x.boundingBox.clone()),x.boundingSphere!==null&&(w.boundingSphere=x.boundingSphere.clone()),w.drawRange.start=x.drawRange.start,w.drawRange.count=x.drawRange.count,w.userData=Object.assign({},x.userData),M.geometry=w}let E=l[T];w.setAttribute(T,new Xi(E.array,E.itemSize,E.normalized))}Ht.prototype.copy.call(M,v),this.parser.assignFinalMaterial(M),p.push(M)}return h.isGroup?(h.clear(),h.add(...p),h):p[0]}))}},rg="glTF",ra=12,eg={JSON:1313821514,BIN:5130562},yf=class{constructor(e){this.name=ot.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,ra),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==rg)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let r=this.header.length-ra,s=new DataView(e,ra),o=0;for(;o<r;){let a=s.getUint32(o,!0);o+=4;let l=s.getUint32(o,!0);if(o+=4,l===eg.JSON){let c=new Uint8Array(e,ra+o,a);this.content=n.decode(c)}else if(l===eg.BIN){let c=ra+o;this.body=e.slice(c,c+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},xf=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=ot.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,r=this.dracoLoader,s=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},l={},c={};for(let h in o){let u=wf[h]||h.toLowerCase();a[u]=o[h]}for(let h in e.attributes){let u=wf[h]||h.toLowerCase();if(o[h]!==void 0){let f=n.accessors[e.attributes[h]],p=Gs[f.componentType];c[u]=p.name,l[u]=f.normalized===!0}}return t.getDependency("bufferView",s).then(function(h){return new Promise(function(u,f){r.decodeDracoFile(h,function(p){for(let v in p.attributes){let y=p.attributes[v],m=l[v];m!==void 0&&(y.normalized=m)}u(p)},a,c,Lt,f)})})}},bf=class{constructor(){this.name=ot.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),r=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*r,e.offset.x,-e.repeat.x*r,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},Mf=class{constructor(){this.name=ot.KHR_MESH_QUANTIZATION}},Lc=class extends Si{constructor(e,t,n,r){super(e,t,n,r)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r*3+r;for(let o=0;o!==r;o++)t[o]=n[s+o];return t}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=a*2,c=a*3,h=r-t,u=(n-t)/h,f=u*u,p=f*u,v=e*c,y=v-c,m=-2*p+3*f,g=p-f,A=1-m,M=g-f+u;for(let w=0;w!==a;w++){let T=o[y+w+a],E=o[y+w+l]*h,x=o[v+w+a],b=o[v+w]*h;s[w]=A*T+M*E+m*x+g*b}return s}},oS=new zn,Sf=class extends Lc{interpolate_(e,t,n,r){let s=super.interpolate_(e,t,n,r);return oS.fromArray(s).normalize().toArray(s),s}},ei={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},Gs={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},tg={9728:Mt,9729:Rt,9984:Ol,9985:Os,9986:Xr,9987:Wn},ng={33071:Rn,33648:ys,10497:yr},Ju={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},wf={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},Mr={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},aS={CUBICSPLINE:void 0,LINEAR:Fr,STEP:Dr},ju={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function lS(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new Hr({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:Qn})),i.DefaultMaterial}function Zr(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function Ri(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function cS(i,e,t){let n=!1,r=!1,s=!1;for(let c=0,h=e.length;c<h;c++){let u=e[c];if(u.POSITION!==void 0&&(n=!0),u.NORMAL!==void 0&&(r=!0),u.COLOR_0!==void 0&&(s=!0),n&&r&&s)break}if(!n&&!r&&!s)return Promise.resolve(i);let o=[],a=[],l=[];for(let c=0,h=e.length;c<h;c++){let u=e[c];if(n){let f=u.POSITION!==void 0?t.getDependency("accessor",u.POSITION):i.attributes.position;o.push(f)}if(r){let f=u.NORMAL!==void 0?t.getDependency("accessor",u.NORMAL):i.attributes.normal;a.push(f)}if(s){let f=u.COLOR_0!==void 0?t.getDependency("accessor",u.COLOR_0):i.attributes.color;l.push(f)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l)]).then(function(c){let h=c[0],u=c[1],f=c[2];return n&&(i.morphAttributes.position=h),r&&(i.morphAttributes.normal=u),s&&(i.morphAttributes.color=f),i.morphTargetsRelative=!0,i})}function hS(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,r=t.length;n<r;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function uS(i){let e,t=i.extensions&&i.extensions[ot.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+Qu(t.attributes):e=i.indices+":"+Qu(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,r=i.targets.length;n<r;n++)e+=":"+Qu(i.targets[n]);return e}function Qu(i){let e="",t=Object.keys(i).sort();for(let n=0,r=t.length;n<r;n++)e+=t[n]+":"+i[t[n]]+";";return e}function Af(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function fS(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var dS=new et,Tf=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new sS,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,r=-1,s=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let l=a.match(/Version\/(\d+)/);r=n&&l?parseInt(l[1],10):-1,s=a.indexOf("Firefox")>-1,o=s?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&r<17||s&&o<98?(this.textureLoader=new Oo(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new Go(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new Qi(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,r=this.json,s=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][r.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:r.asset,parser:n,userData:{}};return Zr(s,a,r),Ri(a,r),Promise.all(n._invokeAll(function(l){return l.afterRoot&&l.afterRoot(a)})).then(function(){for(let l of a.scenes)l.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let r=0,s=t.length;r<s;r++){let o=t[r].joints;for(let a=0,l=o.length;a<l;a++)e[o[a]].isBone=!0}for(let r=0,s=e.length;r<s;r++){let o=e[r];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let r=n.clone(),s=(o,a)=>{let l=this.associations.get(o);l!=null&&this.associations.set(a,l);for(let[c,h]of o.children.entries())s(h,a.children[c])};return s(n,r),r.name+="_instance_"+e.uses[t]++,r}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let r=e(t[n]);if(r)return r}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let r=0;r<t.length;r++){let s=e(t[r]);s&&n.push(s)}return n}getDependency(e,t){let n=e+":"+t,r=this.cache.get(n);if(!r){switch(e){case"scene":r=this.loadScene(t);break;case"node":r=this._invokeOne(function(s){return s.loadNode&&s.loadNode(t)});break;case"mesh":r=this._invokeOne(function(s){return s.loadMesh&&s.loadMesh(t)});break;case"accessor":r=this.loadAccessor(t);break;case"bufferView":r=this._invokeOne(function(s){return s.loadBufferView&&s.loadBufferView(t)});break;case"buffer":r=this.loadBuffer(t);break;case"material":r=this._invokeOne(function(s){return s.loadMaterial&&s.loadMaterial(t)});break;case"texture":r=this._invokeOne(function(s){return s.loadTexture&&s.loadTexture(t)});break;case"skin":r=this.loadSkin(t);break;case"animation":r=this._invokeOne(function(s){return s.loadAnimation&&s.loadAnimation(t)});break;case"camera":r=this.loadCamera(t);break;default:if(r=this._invokeOne(function(s){return s!=this&&s.getDependency&&s.getDependency(e,t)}),!r)throw new Error("Unknown type: "+e);break}this.cache.add(n,r)}return r}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,r=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(r.map(function(s,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[ot.KHR_BINARY_GLTF].body);let r=this.options;return new Promise(function(s,o){n.load(er.resolveURL(t.uri,r.path),s,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let r=t.byteLength||0,s=t.byteOffset||0;return n.slice(s,s+r)})}loadAccessor(e){let t=this,n=this.json,r=this.json.accessors[e];if(r.bufferView===void 0&&r.sparse===void 0){let o=Ju[r.type],a=Gs[r.componentType],l=r.normalized===!0,c=new a(r.count*o);return Promise.resolve(new ht(c,o,l))}let s=[];return r.bufferView!==void 0?s.push(this.getDependency("bufferView",r.bufferView)):s.push(null),r.sparse!==void 0&&(s.push(this.getDependency("bufferView",r.sparse.indices.bufferView)),s.push(this.getDependency("bufferView",r.sparse.values.bufferView))),Promise.all(s).then(function(o){let a=o[0],l=Ju[r.type],c=Gs[r.componentType],h=c.BYTES_PER_ELEMENT,u=h*l,f=r.byteOffset||0,p=r.bufferView!==void 0?n.bufferViews[r.bufferView].byteStride:void 0,v=r.normalized===!0,y,m;if(p&&p!==u){let g=Math.floor(f/p),A="InterleavedBuffer:"+r.bufferView+":"+r.componentType+":"+g+":"+r.count,M=t.cache.get(A);M||(y=new c(a,g*p,r.count*p/h),M=new As(y,p/h),t.cache.add(A,M)),m=new Ts(M,l,f%p/h,v)}else a===null?y=new c(r.count*l):y=new c(a,f,r.count*l),m=new ht(y,l,v);if(r.sparse!==void 0){let g=Ju.SCALAR,A=Gs[r.sparse.indices.componentType],M=r.sparse.indices.byteOffset||0,w=r.sparse.values.byteOffset||0,T=new A(o[1],M,r.sparse.count*g),E=new c(o[2],w,r.sparse.count*l);a!==null&&(m=new ht(m.array.slice(),m.itemSize,m.normalized)),m.normalized=!1;for(let x=0,b=T.length;x<b;x++){let P=T[x];if(m.setX(P,E[x*l]),l>=2&&m.setY(P,E[x*l+1]),l>=3&&m.setZ(P,E[x*l+2]),l>=4&&m.setW(P,E[x*l+3]),l>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}m.normalized=v}return m})}loadTexture(e){let t=this.json,n=this.options,s=t.textures[e].source,o=t.images[s],a=this.textureLoader;if(o.uri){let l=n.manager.getHandler(o.uri);l!==null&&(a=l)}return this.loadTextureImage(e,s,a)}loadTextureImage(e,t,n){let r=this,s=this.json,o=s.textures[e],a=s.images[t],l=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[l])return this.textureCache[l];let c=this.loadImageSource(t,n).then(function(h){h.flipY=!1,h.name=o.name||a.name||"",h.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(h.name=a.uri);let f=(s.samplers||{})[o.sampler]||{};return h.magFilter=tg[f.magFilter]||Rt,h.minFilter=tg[f.minFilter]||Wn,h.wrapS=ng[f.wrapS]||yr,h.wrapT=ng[f.wrapT]||yr,h.generateMipmaps=!h.isCompressedTexture&&h.minFilter!==Mt&&h.minFilter!==Rt,r.associations.set(h,{textures:e}),h}).catch(function(){return null});return this.textureCache[l]=c,c}loadImageSource(e,t){let n=this,r=this.json,s=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(f=>f.clone());let o=r.images[e],a=self.URL||self.webkitURL,l=o.uri||"",c=!1,h;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)h=n.getDependency("bufferView",o.bufferView).then(function(f){return new Promise(function(p,v){t.parse(f,p,v)})});else{if(o.bufferView!==void 0)l=n.getDependency("bufferView",o.bufferView).then(function(f){c=!0;let p=new Blob([f],{type:o.mimeType});return l=a.createObjectURL(p),l});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");h=Promise.resolve(l).then(function(f){return new Promise(function(p,v){let y=p;t.isImageBitmapLoader===!0&&(y=function(m){let g=new cn(m);g.needsUpdate=!0,p(g)}),t.load(er.resolveURL(f,s.path),y,void 0,v)})})}let u=h.then(function(f){return c===!0&&a.revokeObjectURL(l),Ri(f,o),f.userData.mimeType=o.mimeType||fS(o.uri),f}).catch(function(f){throw console.error("THREE.GLTFLoader: Couldn't load texture",l),f});return this.sourceCache[e]=u,u}assignTexture(e,t,n,r){let s=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),s.extensions[ot.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[ot.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let l=s.associations.get(o);o=s.extensions[ot.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),s.associations.set(o,l)}}return r!==void 0&&(o.colorSpace=r),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,r=t.attributes.tangent===void 0,s=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new Rs,Pn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,l.sizeAttenuation=!1,this.cache.add(a,l)),n=l}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new qi,Pn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,this.cache.add(a,l)),n=l}if(r||s||o){let a="ClonedMaterial:"+n.uuid+":";r&&(a+="derivative-tangents:"),s&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let l=this.cache.get(a);l||(l=n.clone(),s&&(l.vertexColors=!0),o&&(l.flatShading=!0),r&&(l.normalScale&&(l.normalScale.y*=-1),l.clearcoatNormalScale&&(l.clearcoatNormalScale.y*=-1)),this.cache.add(a,l),this.associations.set(l,this.associations.get(n))),n=l}e.material=n}getMaterialType(){return Hr}loadMaterial(e){let t=this,n=this.json,r=this.extensions,s=n.materials[e],o,a={},l=s.extensions||{},c=[];if(l[ot.KHR_MATERIALS_UNLIT]){let u=r[ot.KHR_MATERIALS_UNLIT];o=u.getMaterialType(),c.push(u.extendParams(a,s,t))}else{let u=s.pbrMetallicRoughness||{};if(a.color=new $e(1,1,1),a.opacity=1,Array.isArray(u.baseColorFactor)){let f=u.baseColorFactor;a.color.setRGB(f[0],f[1],f[2],Lt),a.opacity=f[3]}u.baseColorTexture!==void 0&&c.push(t.assignTexture(a,"map",u.baseColorTexture,Xt)),a.metalness=u.metallicFactor!==void 0?u.metallicFactor:1,a.roughness=u.roughnessFactor!==void 0?u.roughnessFactor:1,u.metallicRoughnessTexture!==void 0&&(c.push(t.assignTexture(a,"metalnessMap",u.metallicRoughnessTexture)),c.push(t.assignTexture(a,"roughnessMap",u.metallicRoughnessTexture))),o=this._invokeOne(function(f){return f.getMaterialType&&f.getMaterialType(e)}),c.push(Promise.all(this._invokeAll(function(f){return f.extendMaterialParams&&f.extendMaterialParams(e,a)})))}s.doubleSided===!0&&(a.side=Nn);let h=s.alphaMode||ju.OPAQUE;if(h===ju.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,h===ju.MASK&&(a.alphaTest=s.alphaCutoff!==void 0?s.alphaCutoff:.5)),s.normalTexture!==void 0&&o!==ai&&(c.push(t.assignTexture(a,"normalMap",s.normalTexture)),a.normalScale=new it(1,1),s.normalTexture.scale!==void 0)){let u=s.normalTexture.scale;a.normalScale.set(u,u)}if(s.occlusionTexture!==void 0&&o!==ai&&(c.push(t.assignTexture(a,"aoMap",s.occlusionTexture)),s.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=s.occlusionTexture.strength)),s.emissiveFactor!==void 0&&o!==ai){let u=s.emissiveFactor;a.emissive=new $e().setRGB(u[0],u[1],u[2],Lt)}return s.emissiveTexture!==void 0&&o!==ai&&c.push(t.assignTexture(a,"emissiveMap",s.emissiveTexture,Xt)),Promise.all(c).then(function(){let u=new o(a);return s.name&&(u.name=s.name),Ri(u,s),t.associations.set(u,{materials:e}),s.extensions&&Zr(r,u,s),u})}createUniqueName(e){let t=Pt.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,r=this.primitiveCache;function s(a){return n[ot.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(l){return ig(l,a,t)})}let o=[];for(let a=0,l=e.length;a<l;a++){let c=e[a],h=uS(c),u=r[h];if(u)o.push(u.promise);else{let f;c.extensions&&c.extensions[ot.KHR_DRACO_MESH_COMPRESSION]?f=s(c):f=ig(new Nt,c,t),c.mode===ei.TRIANGLE_STRIP?f=f.then(p=>Ku(p,Qo)):c.mode===ei.TRIANGLE_FAN&&(f=f.then(p=>Ku(p,ks))),r[h]={primitive:c,promise:f},o.push(f)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,r=this.extensions,s=n.meshes[e],o=s.primitives,a=[];for(let l=0,c=o.length;l<c;l++){let h=o[l].material===void 0?lS(this.cache):this.getDependency("material",o[l].material);a.push(h)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(l){let c=l.slice(0,l.length-1),h=l[l.length-1],u=[];for(let p=0,v=h.length;p<v;p++){let y=h[p],m=o[p],g,A=c[p];if(m.mode===ei.TRIANGLES||m.mode===ei.TRIANGLE_STRIP||m.mode===ei.TRIANGLE_FAN||m.mode===void 0){let M=s.isSkinnedMesh===!0,w=y.hasAttribute("skinIndex")&&y.hasAttribute("skinWeight");M&&w===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),g=M&&w?new To(y,A):new St(y,A),g.isSkinnedMesh===!0&&g.normalizeSkinWeights()}else if(m.mode===ei.LINES)g=new Co(y,A);else if(m.mode===ei.LINE_STRIP)g=new Mi(y,A);else if(m.mode===ei.LINE_LOOP)g=new zr(y,A);else if(m.mode===ei.POINTS)g=new Io(y,A);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+m.mode);Object.keys(g.geometry.morphAttributes).length>0&&hS(g,s),g.name=t.createUniqueName(s.name||"mesh_"+e),Ri(g,s),m.extensions&&Zr(r,g,m),t.assignFinalMaterial(g),u.push(g)}for(let p=0,v=u.length;p<v;p++)t.associations.set(u[p],{meshes:e,primitives:p});if(u.length===1)return s.extensions&&Zr(r,u[0],s),u[0];let f=new kn;s.extensions&&Zr(r,f,s),t.associations.set(f,{meshes:e});for(let p=0,v=u.length;p<v;p++)f.add(u[p]);return f})}loadCamera(e){let t,n=this.json.cameras[e],r=n[n.type];if(!r){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new Kt(Mc.radToDeg(r.yfov),r.aspectRatio||1,r.znear||1,r.zfar||2e6):n.type==="orthographic"&&(t=new Vn(-r.xmag,r.xmag,r.ymag,-r.ymag,r.znear,r.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),Ri(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let r=0,s=t.joints.length;r<s;r++)n.push(this._loadNodeShallow(t.joints[r]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(r){let s=r.pop(),o=r,a=[],l=[];for(let c=0,h=o.length;c<h;c++){let u=o[c];if(u){a.push(u);let f=new et;s!==null&&f.fromArray(s.array,c*16),l.push(f)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[c])}return new Eo(a,l)})}loadAnimation(e){let t=this.json,n=this,r=t.animations[e],s=r.name?r.name:"animation_"+e,o=[],a=[],l=[],c=[],h=[];for(let u=0,f=r.channels.length;u<f;u++){let p=r.channels[u],v=r.samplers[p.sampler],y=p.target,m=y.node,g=r.parameters!==void 0?r.parameters[v.input]:v.input,A=r.parameters!==void 0?r.parameters[v.output]:v.output;y.node!==void 0&&(o.push(this.getDependency("node",m)),a.push(this.getDependency("accessor",g)),l.push(this.getDependency("accessor",A)),c.push(v),h.push(y))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l),Promise.all(c),Promise.all(h)]).then(function(u){let f=u[0],p=u[1],v=u[2],y=u[3],m=u[4],g=[];for(let M=0,w=f.length;M<w;M++){let T=f[M],E=p[M],x=v[M],b=y[M],P=m[M];if(T===void 0)continue;T.updateMatrix&&T.updateMatrix();let I=n._createAnimationTracks(T,E,x,b,P);if(I)for(let F=0;F<I.length;F++)g.push(I[F])}let A=new Uo(s,void 0,g);return Ri(A,r),A})}createNodeMesh(e){let t=this.json,n=this,r=t.nodes[e];return r.mesh===void 0?null:n.getDependency("mesh",r.mesh).then(function(s){let o=n._getNodeRef(n.meshCache,r.mesh,s);return r.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let l=0,c=r.weights.length;l<c;l++)a.morphTargetInfluences[l]=r.weights[l]}),o})}loadNode(e){let t=this.json,n=this,r=t.nodes[e],s=n._loadNodeShallow(e),o=[],a=r.children||[];for(let c=0,h=a.length;c<h;c++)o.push(n.getDependency("node",a[c]));let l=r.skin===void 0?Promise.resolve(null):n.getDependency("skin",r.skin);return Promise.all([s,Promise.all(o),l]).then(function(c){let h=c[0],u=c[1],f=c[2];f!==null&&h.traverse(function(p){p.isSkinnedMesh&&p.bind(f,dS)});for(let p=0,v=u.length;p<v;p++)h.add(u[p]);if(h.userData.pivot!==void 0&&u.length>0){let p=h.userData.pivot,v=u[0];h.pivot=new W().fromArray(p),h.position.x-=p[0],h.position.y-=p[1],h.position.z-=p[2],v.position.set(0,0,0),delete h.userData.pivot}return h})}_loadNodeShallow(e){let t=this.json,n=this.extensions,r=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let s=t.nodes[e],o=s.name?r.createUniqueName(s.name):"",a=[],l=r._invokeOne(function(c){return c.createNodeMesh&&c.createNodeMesh(e)});return l&&a.push(l),s.camera!==void 0&&a.push(r.getDependency("camera",s.camera).then(function(c){return r._getNodeRef(r.cameraCache,s.camera,c)})),r._invokeAll(function(c){return c.createNodeAttachment&&c.createNodeAttachment(e)}).forEach(function(c){a.push(c)}),this.nodeCache[e]=Promise.all(a).then(function(c){let h;if(s.isBone===!0?h=new Es:c.length>1?h=new kn:c.length===1?h=c[0]:h=new Ht,h!==c[0])for(let u=0,f=c.length;u<f;u++)h.add(c[u]);if(s.name&&(h.userData.name=s.name,h.name=o),Ri(h,s),s.extensions&&Zr(n,h,s),s.matrix!==void 0){let u=new et;u.fromArray(s.matrix),h.applyMatrix4(u)}else s.translation!==void 0&&h.position.fromArray(s.translation),s.rotation!==void 0&&h.quaternion.fromArray(s.rotation),s.scale!==void 0&&h.scale.fromArray(s.scale);if(!r.associations.has(h))r.associations.set(h,{});else if(s.mesh!==void 0&&r.meshCache.refs[s.mesh]>1){let u=r.associations.get(h);r.associations.set(h,{...u})}return r.associations.get(h).nodes=e,h}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],r=this,s=new kn;n.name&&(s.name=r.createUniqueName(n.name)),Ri(s,n),n.extensions&&Zr(t,s,n);let o=n.nodes||[],a=[];for(let l=0,c=o.length;l<c;l++)a.push(r.getDependency("node",o[l]));return Promise.all(a).then(function(l){for(let h=0,u=l.length;h<u;h++){let f=l[h];f.parent!==null?s.add(jm(f)):s.add(f)}let c=h=>{let u=new Map;for(let[f,p]of r.associations)(f instanceof Pn||f instanceof cn)&&u.set(f,p);return h.traverse(f=>{let p=r.associations.get(f);p!=null&&u.set(f,p)}),u};return r.associations=c(s),s})}_createAnimationTracks(e,t,n,r,s){let o=[],a=e.name?e.name:e.uuid,l=[];function c(p){p.morphTargetInfluences&&l.push(p.name?p.name:p.uuid)}Mr[s.path]===Mr.weights?(c(e),e.isGroup&&e.children.forEach(c)):l.push(a);let h;switch(Mr[s.path]){case Mr.weights:h=Ki;break;case Mr.rotation:h=Ji;break;case Mr.translation:case Mr.scale:h=br;break;default:n.itemSize===1?h=Ki:h=br;break}let u=r.interpolation!==void 0?aS[r.interpolation]:Fr,f=this._getArrayFromAccessor(n);for(let p=0,v=l.length;p<v;p++){let y=new h(l[p]+"."+Mr[s.path],t.array,f,u);r.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(y),o.push(y)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=Af(t.constructor),r=new Float32Array(t.length);for(let s=0,o=t.length;s<o;s++)r[s]=t[s]*n;t=r}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let r=this instanceof Ji?Sf:Lc;return new r(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function pS(i,e,t){let n=e.attributes,r=new Hn;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],l=a.min,c=a.max;if(l!==void 0&&c!==void 0){if(r.set(new W(l[0],l[1],l[2]),new W(c[0],c[1],c[2])),a.normalized){let h=Af(Gs[a.componentType]);r.min.multiplyScalar(h),r.max.multiplyScalar(h)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let s=e.targets;if(s!==void 0){let a=new W,l=new W;for(let c=0,h=s.length;c<h;c++){let u=s[c];if(u.POSITION!==void 0){let f=t.json.accessors[u.POSITION],p=f.min,v=f.max;if(p!==void 0&&v!==void 0){if(l.setX(Math.max(Math.abs(p[0]),Math.abs(v[0]))),l.setY(Math.max(Math.abs(p[1]),Math.abs(v[1]))),l.setZ(Math.max(Math.abs(p[2]),Math.abs(v[2]))),f.normalized){let y=Af(Gs[f.componentType]);l.multiplyScalar(y)}a.max(l)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}r.expandByVector(a)}i.boundingBox=r;let o=new In;r.getCenter(o.center),o.radius=r.min.distanceTo(r.max)/2,i.boundingSphere=o}function ig(i,e,t){let n=e.attributes,r=[];function s(o,a){return t.getDependency("accessor",o).then(function(l){i.setAttribute(a,l)})}for(let o in n){let a=wf[o]||o.toLowerCase();a in i.attributes||r.push(s(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});r.push(o)}return st.workingColorSpace!==Lt&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${st.workingColorSpace}" not supported.`),Ri(i,e),pS(i,e,t),Promise.all(r).then(function(){return e.targets!==void 0?cS(i,e.targets,t):i})}var sg=Math.tan(15*Math.PI/180),mS=14,og=.02;function ag(i,e,t,n){let r=gS(i,t),s=i.length/3,o=new Float32Array(s),a=n.length-1;for(let l=0;l<s;l+=1){let c=Math.min(Math.max(e[3*l+1],-1),1),h=Math.acos(c)/Math.PI*a,u=Math.min(Math.floor(h),a-1),f=n[u]+(h-u)*(n[u+1]-n[u]);o[l]=f>0?f*r.open(i[3*l],i[3*l+1],i[3*l+2],c):0}return o}function gS(i,e){let[t,n,r,s]=[1/0,1/0,-1/0,-1/0];for(let h=0;h<i.length;h+=3)t=Math.min(t,i[h]),r=Math.max(r,i[h]),n=Math.min(n,i[h+2]),s=Math.max(s,i[h+2]);let o=Math.max(r-t,s-n,1e-9)/191,a=new Float32Array(36864).fill(-1/0),l=h=>(h-t)/o,c=h=>(h-n)/o;for(let h=0;h<e.length;h+=3){let[u,f,p]=[3*e[h],3*e[h+1],3*e[h+2]],[v,y,m,g,A,M]=[l(i[u]),c(i[u+2]),l(i[f]),c(i[f+2]),l(i[p]),c(i[p+2])],w=(m-v)*(M-y)-(A-v)*(g-y);for(let T=Math.max(Math.ceil(Math.min(y,g,M)),0);T<=Math.min(Math.floor(Math.max(y,g,M)),191);T+=1)for(let E=Math.max(Math.ceil(Math.min(v,m,A)),0);E<=Math.min(Math.floor(Math.max(v,m,A)),191);E+=1){let x=((E-v)*(M-y)-(A-v)*(T-y))/w,b=((m-v)*(T-y)-(E-v)*(g-y))/w;if(!(x>=-1e-6&&b>=-1e-6&&x+b<=1+1e-6))continue;let P=i[u+1]+x*(i[f+1]-i[u+1])+b*(i[p+1]-i[u+1]);P>a[T*192+E]&&(a[T*192+E]=P)}}return{open(h,u,f,p){let v=u+og+1.5*o*Math.min(Math.sqrt(Math.max(1-p*p,0))/Math.max(p,.1),8),y=0;for(let m=0;m<9;m+=1){let[g,A]=m===8?[0,0]:[Math.cos(m*Math.PI/4)*sg,Math.sin(m*Math.PI/4)*sg],M=!1;for(let w=0;w<mS&&!M;w+=1){let T=og+.015*(w*w+w),E=Math.round(c(f+A*T)),x=Math.round(l(h+g*T));if(E<0||x<0||E>=192||x>=192)break;M=a[E*192+x]>v+T}M||(y+=1)}return y/9}}}var lg=2.3,sa=5e6;function cg(i){let e=new Uint16Array(gi(i.positions)),t=Float32Array.from(e,(a,l)=>i.low[l%3]+(i.high[l%3]-i.low[l%3])*a/65535),n=Float32Array.from(new Int16Array(gi(i.normals)),a=>a/32767),r=Float32Array.from(new Uint8Array(gi(i.dust)),a=>a/255),s=i.high.map((a,l)=>a-i.low[l]),o=Math.min(1,lg/Math.max(...s));for(let a=0;a<t.length;a+=1)t[a]=(t[a]-i.low[a%3]-s[a%3]/2)*o;return hg(t,n,new Uint16Array(gi(i.triangles)),r)}function Ef(i,e,t){let n=t==="z"?vS(i):i,{positions:r,indices:s}=n;if(s.length<3)throw new oe(`${n.name} has no triangle`,"Export the mesh with its faces");if(s.length/3>sa)throw new oe(`${n.name} has ${(s.length/3).toLocaleString("en")} triangles, more than ${sa.toLocaleString("en")}`,"Decimate it");let o=r.length/3;for(let y of s)if(y>=o)throw new oe(`${n.name} has a face with vertex ${y} of ${o} vertices`,"The file is damaged");let a=[1/0,1/0,1/0],l=[-1/0,-1/0,-1/0];for(let y of s)for(let m=0;m<3;m+=1){let g=r[3*y+m];if(!Number.isFinite(g))throw new oe(`${n.name} has a vertex whose position is not finite`,"Export it again; a modifier that divides by zero is a usual cause");a[m]=Math.min(a[m],g),l[m]=Math.max(l[m],g)}let c=Math.max(...a.map((y,m)=>l[m]-y));if(!(c>0))throw new oe(`${n.name} has no extent: all its vertices lie in one point`,"Export it again");let h=new Float32Array(r.length);for(let y=0;y<r.length;y+=1)h[y]=(r[y]-(a[y%3]+l[y%3])/2)/c*lg;let u=hg(h,n.normals&&_S(n.normals,o)?n.normals:null,o<65536?Uint16Array.from(s):s,null);u.getAttribute("normal")||u.computeVertexNormals();let f=u.getAttribute("normal").array,p=Rf(n),v=n.tau&&p>0?n.tau.map(y=>y/p):ag(h,f,s,e);return u.setAttribute("dust",new ht(v,1)),u}function Rf(i){let e=0;for(let t of i.tau??[]){if(!(t>=0&&Number.isFinite(t)))throw new oe(`${i.name} has a vertex with tau = ${t}, which is no optical thickness`,"tau is a number from 0 on");e=Math.max(e,t)}return e}function vS(i){let e=t=>t.map((n,r)=>r%3===0?n:r%3===1?t[r+1]:-t[r-1]);return{...i,positions:e(i.positions),normals:i.normals&&e(i.normals)}}function _S(i,e){if(i.length!==3*e)return!1;for(let t=0;t<i.length;t+=3)if(!(Math.hypot(i[t],i[t+1],i[t+2])>1e-6))return!1;return!0}function hg(i,e,t,n){let r=new Nt;return r.setAttribute("position",new ht(i,3)),e&&r.setAttribute("normal",new ht(e,3)),n&&r.setAttribute("dust",new ht(n,1)),r.setIndex(new ht(t,1)),r}var dg=1179937895,pg=1313821514,mg=5130562,yS={5120:1,5121:1,5122:2,5123:2,5125:4,5126:4},xS={SCALAR:1,VEC2:2,VEC3:3,VEC4:4},ug=64,bS=252,Nc="KHR_mesh_quantization";async function gg(i,e){let{document:t,binary:n}=SS(i,e),r=TS(wS(i,t,n.byteLength),n),{scene:s}=await new Ic().parseAsync(r,"");s.updateMatrixWorld(!0);let o=[];return s.traverse(a=>{a instanceof St&&o.push(a)}),MS(i,o)}function MS(i,e){let t=e.map(({geometry:h})=>[h.getAttribute("position").count,h.getIndex()?.count??h.getAttribute("position").count]),n=new Float32Array(3*t.reduce((h,[u])=>h+u,0)),r=new Uint32Array(t.reduce((h,[,u])=>h+u,0)),o=e.length>0&&e.every(({geometry:h})=>h.getAttribute("normal"))?new Float32Array(n.length):null,a=new W,[l,c]=[0,0];return e.forEach(({geometry:h,matrixWorld:u},f)=>{let p=new Ke().getNormalMatrix(u),v=u.determinant()<0,[y,m,g]=[h.getAttribute("position"),h.getAttribute("normal"),h.getIndex()];for(let M=0;M<y.count;M+=1)fg(a,y,M).applyMatrix4(u).toArray(n,3*(l+M)),o&&fg(a,m,M).applyMatrix3(p).normalize().toArray(o,3*(l+M));let A=t[f][1];for(let M=0;M<A;M+=1){let w=v?M-M%3+(3-M%3)%3:M;r[c+M]=l+(g?g.getX(w):w)}l+=y.count,c+=A}),{name:i,positions:n,normals:o,indices:r}}function fg(i,e,t){return i.fromBufferAttribute(e,t)}function SS(i,e){let t=new DataView(e);if(e.byteLength<20||t.getUint32(0,!0)!==dg||t.getUint32(4,!0)!==2)throw new oe(`${i} is not a GLB file of version 2`,"Export it as glTF binary (.glb)");let n=null,r=new Uint8Array(0);for(let s=12;s+8<=e.byteLength;){let[o,a]=[t.getUint32(s,!0),t.getUint32(s+4,!0)];if(s+8+o>e.byteLength)throw new oe(`${i} is cut short`,"Export it again");let l=new Uint8Array(e,s+8,o);a===pg&&n===null&&(n=JSON.parse(new TextDecoder().decode(l))),a===mg&&!r.length&&(r=l),s+=8+o}if(!hn(n))throw new oe(`${i} has no description`,"Export it again");return{document:n,binary:r}}function wS(i,e,t){let n=b=>new oe(`${i} has ${b} that lead nowhere, or beyond the file`,"The file is damaged; export it again"),r=(b,P)=>{let I=b[P]??[];if(!Array.isArray(I)||!I.every(hn))throw n(P);return I},s=(b,P,I=0)=>{let F=b[P]??I;if(typeof F!="number"||!Number.isSafeInteger(F)||F<0)throw new oe(`${i}: ${P} = ${Bt(F)} is no size`,"The file is damaged; export it again");return F},o=(b,P,I)=>{if(typeof b!="number"||!Number.isInteger(b)||b<0||b>=P)throw n(I);return b},a=Array.isArray(e.extensionsRequired)?e.extensionsRequired.map(String):[],l=a.filter(b=>b!==Nc&&!/^KHR_(materials|texture|lights)/.test(b));if(l.length)throw new oe(`${i} is compressed, or needs ${l.join(", ").slice(0,80)}`,"Export it without compression or extensions");let[c,...h]=r(e,"buffers");if(!c||h.length||c.uri!==void 0)throw new oe(`${i} keeps its numbers in other files`,"Export it as glTF binary (.glb), in one file");if(s(c,"byteLength")>t)throw new oe(`${i} is cut short: it claims ${s(c,"byteLength")} bytes of numbers and has ${t}`,"Export it again");let u=r(e,"bufferViews").map(b=>{let[P,I,F]=[s(b,"byteOffset"),s(b,"byteLength"),s(b,"byteStride")];if(o(b.buffer,1,"bufferViews")!==0||P+I>t||F>bS)throw n("bufferViews");return{buffer:0,byteOffset:P,byteLength:I,...F?{byteStride:F}:{}}}),f=r(e,"accessors").map(b=>{let P=(yS[Number(b.componentType)]??0)*(xS[String(b.type)]??0);if(!P||b.sparse!==void 0||b.bufferView===void 0)return null;let[I,F]=[s(b,"count"),s(b,"byteOffset")],B=o(b.bufferView,u.length,"accessors"),{byteLength:z,byteStride:D}=u[B];if(I&&F+(I-1)*(D??P)+P>z||D!==void 0&&D<P)throw n("accessors");let $=b.type==="VEC3"?{min:[0,0,0],max:[0,0,0]}:{};return{bufferView:B,byteOffset:F,count:I,componentType:Number(b.componentType),type:String(b.type),normalized:b.normalized===!0,...$}}),p=b=>{let P=o(b,f.length,"meshes");if(!f[P])throw new oe(`${i} holds numbers in a way that is not supported`,"Export it again without sparse accessors");return P},v=[],y=r(e,"meshes").map(b=>{let P=0,I=r(b,"primitives").flatMap(F=>{let[B,z]=[s(F,"mode",4),F.attributes];if(![4,5,6].includes(B)||!hn(z)||z.POSITION===void 0)return[];let D=p(z.POSITION),$=z.NORMAL===void 0?void 0:p(z.NORMAL),q=F.indices===void 0?void 0:p(F.indices);if(f[D].type!=="VEC3"||$!==void 0&&(f[$].type!=="VEC3"||f[$].count!==f[D].count)||q!==void 0&&(f[q].type!=="SCALAR"||![5121,5123,5125].includes(f[q].componentType)))throw n("meshes");let K=f[q??D].count;return P+=B===4?K/3:K,K<3?[]:[{mode:B,attributes:{POSITION:D,...$===void 0?{}:{NORMAL:$}},...q===void 0?{}:{indices:q}}]});return v.push(P),{primitives:I}}),m=r(e,"nodes"),g=new Map,A=0,M=m.map((b,P)=>{let I=b.children??[];if(!Array.isArray(I))throw n("nodes");for(let z of I){if(g.has(o(z,m.length,"nodes")))throw n("nodes");g.set(z,P)}let F=b.mesh===void 0?void 0:o(b.mesh,y.length,"nodes");A+=F===void 0?0:v[F];let B=F!==void 0&&y[F].primitives.length>0;return{...AS(b),...I.length?{children:I}:{},...B?{mesh:F}:{}}});for(let b=0;b<m.length;b+=1){let P=0;for(let I=g.get(b);I!==void 0;I=g.get(I))if((P+=1)>ug)throw new oe(`${i} has nodes that are their own ancestors, or more than ${ug} deep`,"Export it again")}if(A>sa)throw new oe(`${i} has ${Math.round(A).toLocaleString("en")} triangles, more than ${sa.toLocaleString("en")}`,"Decimate it");let w=r(e,"scenes"),E=(w.length?w[o(e.scene??0,w.length,"scenes")]:{nodes:m.map((b,P)=>P).filter(b=>!g.has(b))}).nodes??[];if(!Array.isArray(E))throw n("scenes");for(let b of E)o(b,m.length,"scenes");let x=[...new Set(E)];return{asset:{version:"2.0"},...a.includes(Nc)?{extensionsUsed:[Nc],extensionsRequired:[Nc]}:{},scene:0,scenes:[{nodes:x.filter(b=>!g.has(b))}],nodes:M,meshes:y.map(b=>b.primitives.length?b:{primitives:[{attributes:{}}]}),accessors:f.map(b=>b??{count:0,componentType:5126,type:"SCALAR"}),bufferViews:u,buffers:[{byteLength:t}]}}function AS(i){let e={};for(let[t,n]of[["matrix",16],["translation",3],["rotation",4],["scale",3]]){let r=i[t];Array.isArray(r)&&r.length===n&&r.every(s=>typeof s=="number"&&Number.isFinite(s))&&(e[t]=r)}return e}function TS(i,e){let t=new TextEncoder().encode(JSON.stringify(i)),[n,r]=[Math.ceil(t.length/4)*4,Math.ceil(e.length/4)*4],s=new Uint8Array(28+n+r).fill(32,20,20+n),o=new DataView(s.buffer);return[dg,2,s.length,n,pg].forEach((a,l)=>o.setUint32(4*l,a,!0)),s.set(t,20),o.setUint32(20+n,r,!0),o.setUint32(24+n,mg,!0),s.set(e,28+n),s.buffer}var xg=[".obj",".ply",".glb"],vg=400*2**20,ES=65536;async function bg(i,e){if(e.byteLength>vg)throw new oe(`${i} has ${Math.round(e.byteLength/2**20)} MiB, more than ${vg/2**20}`,"Decimate it");let t=i.slice(i.lastIndexOf(".")).toLowerCase();try{return t===".obj"?RS(i,new TextDecoder().decode(e)):t===".ply"?PS(i,e):await gg(i,e)}catch(n){throw n instanceof oe?n:new oe(`${i} is not a mesh that can be read: ${n instanceof Error?n.message:String(n)}`,"Export it again as OBJ, PLY or GLB")}}function RS(i,e){let t=[],n=[],r=[],s=[],o=0;for(let p=0;p<e.length;){let v=e.indexOf(`
`,p);v<0&&(v=e.length),o+=1;let y=e.charCodeAt(p);for(let m=p;(y===32||y===9)&&m<v;m+=1)y=e.charCodeAt(m+1);if(y===118||y===102){let m=e.slice(p,v);for(;/\\\s*$/.test(m)&&v<e.length;){let A=e.indexOf(`
`,v+1);m=m.replace(/\\\s*$/," ")+e.slice(v+1,A<0?e.length:A),v=A<0?e.length:A,o+=1}let g=m.replace(/#.*/,"").trim().split(/\s+/);if(g[0]==="v")t.push(..._g(g,i,o));else if(g[0]==="vn")n.push(..._g(g,i,o));else if(g[0]==="f"){let A=g.slice(1).map(M=>CS(M,t.length/3,n.length/3,i,o));if(A.length<3)throw new oe(`${i}, line ${o}: a face with ${A.length} corners`,"Export it again");for(let M=1;M+1<A.length;M+=1)for(let[w,T]of[A[0],A[M],A[M+1]])r.push(w),s.push(T)}}p=v+1}let a=Float32Array.from(t);if(!n.length||s.some(p=>p<0))return{name:i,positions:a,normals:null,indices:Uint32Array.from(r)};let l=new Map,c=new Uint32Array(r.length),[h,u]=[[],[]],f=n.length/3;return r.forEach((p,v)=>{let y=p*f+s[v],m=l.get(y);if(m===void 0){m=l.size,l.set(y,m);for(let g=0;g<3;g+=1)h.push(t[3*p+g]),u.push(n[3*s[v]+g])}c[v]=m}),{name:i,positions:Float32Array.from(h),normals:Float32Array.from(u),indices:c}}function _g(i,e,t){let[n,r,s]=[Number(i[1]),Number(i[2]),Number(i[3])];if(![n,r,s].every(Number.isFinite))throw new oe(`${e}, line ${t}: ${i.slice(0,4).join(" ").slice(0,60)} is not three numbers`,"Export it again");return[n,r,s]}function CS(i,e,t,n,r){let[s,,o]=i.split("/"),a=(c,h)=>{if(!c)return-1;let u=Number(c),f=u<0?h+u:u-1;if(!Number.isInteger(u)||f<0||f>=h)throw new oe(`${n}, line ${r}: ${i.slice(0,40)} is not among ${h} vertices`,"The file is damaged");return f},l=a(s,e);if(l<0)throw new oe(`${n}, line ${r}: a corner without a vertex`,"The file is damaged");return[l,a(o,t)]}var yg=["vertex_indices","vertex_index"];function IS(i,e,t){let n=[];for(let a of e.split(/\r\n|\r|\n/)){let l=a.trim().split(/\s+/);if(l[0]==="element"&&n.push({name:l[1]??"",count:Number(l[2]),properties:[]}),l[0]!=="property")continue;if(n.at(-1)?.properties.push(l),(l[1]==="list"?[l[2],yg.includes(l[4]??"")?l[3]:void 0]:[]).some(h=>h&&/^(float|double)/.test(h)))throw new oe(`${i} has faces whose vertices are fractions: ${Bt(a.trim())}`,"Export it again")}if(!/^\s*format\s+ascii\b/m.test(e))return;let r=new TextDecoder("latin1").decode(t),s=r.slice(r.indexOf("end_header")+10).split(/\r\n|\r|\n/).filter(a=>a.trim()),o=0;for(let a of n){let l=s.slice(o,o+=a.count);if(a.name==="face")for(let c of l){let h=c.trim().split(/\s+/),u=0;for(let f of a.properties){if(f[1]!=="list"){u+=1;continue}let p=Number(h[u]),v=yg.includes(f[4]??"")?h.slice(u,u+1+p):[h[u]];if(h.length<u+1+p)throw new oe(`${i} breaks off within the face ${Bt(c.trim())}`,"The file is damaged; fetch it again");if(!v.every(y=>/^[+-]?\d+$/.test(y)))throw new oe(`${i} has the face ${Bt(c.trim())}, whose vertices are not whole numbers`,"Export it again");u+=1+p}}}}function PS(i,e){if(new TextDecoder("latin1").decode(e.slice(0,3))!=="ply")throw new oe(`${i} does not begin with "ply"`,"Export it again");let t=new TextDecoder("latin1").decode(e.slice(0,ES)).split("end_header")[0];for(let[,h,u]of t.matchAll(/^\s*element\s+(\S+)\s+(\S+)/gm))if(!(Number(u)<=e.byteLength))throw new oe(`${i} claims ${Bt(u)} of ${Bt(h)}, more than its ${e.byteLength} bytes hold`,"The file is damaged");IS(i,t,e);let n=new Cc,r=/^\s*property\s+\w+\s+tau\s*$/m.test((/element\s+vertex\b[^]*?(?=^\s*element\b|$(?![^]))/m.exec(t)??[""])[0]);r&&n.setCustomPropertyNameMapping({tau:["tau"]});let s=n.parse(e);!s.getIndex()&&/^\s*element\s+face\s+0*[1-9]/m.test(t)&&(s.getAttribute("color")||s.getAttribute("uv"))&&(s=LS(s));let o=s.getAttribute("position")?.array,a=s.getIndex()?.array;if(!o||!a)throw new oe(`${i} has no faces`,"Export the mesh with its faces; clouds of points cannot be shaded");let l=s.getAttribute("normal")?.array,c=r?s.getAttribute("tau")?.array:null;return{name:i,positions:Float32Array.from(o),normals:l?Float32Array.from(l):null,indices:Uint32Array.from(a),tau:c?Float32Array.from(c):null}}function LS(i){for(let e of Object.keys(i.attributes))["position","normal","tau"].includes(e)||i.deleteAttribute(e);return Jm(i,0)}var Dc=class extends Gr{constructor(e){super(e),this.type=Jt,this.outputFormat=xt,this.part=0}parse(e){let P=Math.pow(2.7182818,2.2),I=null,F=null;function B(_,d){let S=0;for(let L=0;L<65536;++L)(L==0||_[L>>3]&1<<(L&7))&&(d[S++]=L);let C=S-1;for(;S<65536;)d[S++]=0;return C}function z(_){for(let d=0;d<16384;d++)_[d]={},_[d].len=0,_[d].lit=0,_[d].p=null}let D={l:0,c:0,lc:0};function $(_,d,S,C,L){for(;S<_;)d=d<<8|Me(C,L),S+=8;S-=_,D.l=d>>S&(1<<_)-1,D.c=d,D.lc=S}let q=new Array(59);function K(_){for(let S=0;S<=58;++S)q[S]=0;for(let S=0;S<65537;++S)q[_[S]]+=1;let d=0;for(let S=58;S>0;--S){let C=d+q[S]>>1;q[S]=d,d=C}for(let S=0;S<65537;++S){let C=_[S];C>0&&(_[S]=C|q[C]++<<6)}}function fe(_,d,S,C,L,U){let N=d,X=0,H=0;for(;C<=L;C++){if(N.value-d.value>S)return!1;$(6,X,H,_,N);let G=D.l;if(X=D.c,H=D.lc,U[C]=G,G==63){if(N.value-d.value>S)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");$(8,X,H,_,N);let Y=D.l+6;if(X=D.c,H=D.lc,C+Y>L+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;Y--;)U[C++]=0;C--}else if(G>=59){let Y=G-59+2;if(C+Y>L+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;Y--;)U[C++]=0;C--}}K(U)}function J(_){return _&63}function ae(_){return _>>6}function ce(_,d,S,C){for(;d<=S;d++){let L=ae(_[d]),U=J(_[d]);if(L>>U)throw new Error("THREE.EXRLoader: Invalid table entry");if(U>14){let N=C[L>>U-14];if(N.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(N.lit++,N.p){let X=N.p;N.p=new Array(N.lit);for(let H=0;H<N.lit-1;++H)N.p[H]=X[H]}else N.p=new Array(1);N.p[N.lit-1]=d}else if(U){let N=0;for(let X=1<<14-U;X>0;X--){let H=C[(L<<14-U)+N];if(H.len||H.p)throw new Error("THREE.EXRLoader: Invalid table entry");H.len=U,H.lit=d,N++}}}return!0}let we={c:0,lc:0};function De(_,d,S,C){_=_<<8|Me(S,C),d+=8,we.c=_,we.lc=d}let ie={c:0,lc:0};function Re(_,d,S,C,L,U,N,X,H){if(_==d){C<8&&(De(S,C,L,U),S=we.c,C=we.lc),C-=8;let G=S>>C;if(G=new Uint8Array([G])[0],X.value+G>H)return!1;let Y=N[X.value-1];for(;G-- >0;)N[X.value++]=Y}else if(X.value<H)N[X.value++]=_;else return!1;ie.c=S,ie.lc=C}function Ue(_){return _&65535}function ze(_){let d=Ue(_);return d>32767?d-65536:d}let me={a:0,b:0};function Xe(_,d){let S=ze(_),L=ze(d),U=S+(L&1)+(L>>1),N=U,X=U-L;me.a=N,me.b=X}function wt(_,d){let S=Ue(_),C=Ue(d),L=S-(C>>1)&65535,U=C+L-32768&65535;me.a=U,me.b=L}function Ve(_,d,S,C,L,U,N){let X=N<16384,H=S>L?L:S,G=1,Y,se;for(;G<=H;)G<<=1;for(G>>=1,Y=G,G>>=1;G>=1;){se=0;let Q=se+U*(L-Y),ee=U*G,ue=U*Y,de=C*G,pe=C*Y,Te,We,he,Ye;for(;se<=Q;se+=ue){let ye=se,Pe=se+C*(S-Y);for(;ye<=Pe;ye+=pe){let Ne=ye+de,gt=ye+ee,nt=gt+de;X?(Xe(_[ye+d],_[gt+d]),Te=me.a,he=me.b,Xe(_[Ne+d],_[nt+d]),We=me.a,Ye=me.b,Xe(Te,We),_[ye+d]=me.a,_[Ne+d]=me.b,Xe(he,Ye),_[gt+d]=me.a,_[nt+d]=me.b):(wt(_[ye+d],_[gt+d]),Te=me.a,he=me.b,wt(_[Ne+d],_[nt+d]),We=me.a,Ye=me.b,wt(Te,We),_[ye+d]=me.a,_[Ne+d]=me.b,wt(he,Ye),_[gt+d]=me.a,_[nt+d]=me.b)}if(S&G){let Ne=ye+ee;X?Xe(_[ye+d],_[Ne+d]):wt(_[ye+d],_[Ne+d]),Te=me.a,_[Ne+d]=me.b,_[ye+d]=Te}}if(L&G){let ye=se,Pe=se+C*(S-Y);for(;ye<=Pe;ye+=pe){let Ne=ye+de;X?Xe(_[ye+d],_[Ne+d]):wt(_[ye+d],_[Ne+d]),Te=me.a,_[Ne+d]=me.b,_[ye+d]=Te}}Y=G,G>>=1}return se}function ft(_,d,S,C,L,U,N,X,H){let G=0,Y=0,se=N,Q=Math.trunc(C.value+(L+7)/8);for(;C.value<Q;)for(De(G,Y,S,C),G=we.c,Y=we.lc;Y>=14;){let ue=G>>Y-14&16383,de=d[ue];if(de.len)Y-=de.len,Re(de.lit,U,G,Y,S,C,X,H,se),G=ie.c,Y=ie.lc;else{if(!de.p)throw new Error("THREE.EXRLoader: hufDecode issues");let pe;for(pe=0;pe<de.lit;pe++){let Te=J(_[de.p[pe]]);for(;Y<Te&&C.value<Q;)De(G,Y,S,C),G=we.c,Y=we.lc;if(Y>=Te&&ae(_[de.p[pe]])==(G>>Y-Te&(1<<Te)-1)){Y-=Te,Re(de.p[pe],U,G,Y,S,C,X,H,se),G=ie.c,Y=ie.lc;break}}if(pe==de.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let ee=8-L&7;for(G>>=ee,Y-=ee;Y>0;){let ue=d[G<<14-Y&16383];if(ue.len)Y-=ue.len,Re(ue.lit,U,G,Y,S,C,X,H,se),G=ie.c,Y=ie.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function mt(_,d,S,C,L,U){let N={value:0},X=S.value,H=re(d,S),G=re(d,S);S.value+=4;let Y=re(d,S);if(S.value+=4,H<0||H>=65537||G<0||G>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let se=new Array(65537),Q=new Array(16384);z(Q);let ee=C-(S.value-X);if(fe(_,S,ee,H,G,se),Y>8*(C-(S.value-X)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");ce(se,H,G,Q),ft(se,Q,_,S,Y,G,U,L,N)}function at(_,d,S){for(let C=0;C<S;++C)d[C]=_[d[C]]}function Vt(_){for(let d=1;d<_.length;d++){let S=_[d-1]+_[d]-128;_[d]=S}}function kt(_,d){let S=0,C=Math.floor((_.length+1)/2),L=0,U=_.length-1;for(;!(L>U||(d[L++]=_[S++],L>U));)d[L++]=_[C++]}function on(_){let d=_.byteLength,S=new Array,C=0,L=new DataView(_);for(;d>0;){let U=L.getInt8(C++);if(U<0){let N=-U;d-=N+1;for(let X=0;X<N;X++)S.push(L.getUint8(C++))}else{let N=U;d-=2;let X=L.getUint8(C++);for(let H=0;H<N+1;H++)S.push(X)}}return S}function Ut(_,d,S,C,L,U){let N=new DataView(U.buffer),X=S[_.idx[0]].width,H=S[_.idx[0]].height,G=3,Y=Math.floor(X/8),se=Math.ceil(X/8),Q=Math.ceil(H/8),ee=X-(se-1)*8,ue=H-(Q-1)*8,de={value:0},pe=new Array(G),Te=new Array(G),We=new Array(G),he=new Array(G),Ye=new Array(G);for(let Pe=0;Pe<G;++Pe)Ye[Pe]=d[_.idx[Pe]],pe[Pe]=Pe<1?0:pe[Pe-1]+se*Q,Te[Pe]=new Float32Array(64),We[Pe]=new Uint16Array(64),he[Pe]=new Uint16Array(se*64);for(let Pe=0;Pe<Q;++Pe){let Ne=8;Pe==Q-1&&(Ne=ue);let gt=8;for(let qe=0;qe<se;++qe){qe==se-1&&(gt=ee);for(let Oe=0;Oe<G;++Oe)We[Oe].fill(0),We[Oe][0]=L[pe[Oe]++],qt(de,C,We[Oe]),_n(We[Oe],Te[Oe]),yn(Te[Oe]);G==3&&An(Te);for(let Oe=0;Oe<G;++Oe)It(Te[Oe],he[Oe],qe*64)}let nt=0;for(let qe=0;qe<G;++qe){let Oe=S[_.idx[qe]].type;for(let lt=8*Pe;lt<8*Pe+Ne;++lt){nt=Ye[qe][lt];for(let Ot=0;Ot<Y;++Ot){let Ze=Ot*64+(lt&7)*8;N.setUint16(nt+0*Oe,he[qe][Ze+0],!0),N.setUint16(nt+2*Oe,he[qe][Ze+1],!0),N.setUint16(nt+4*Oe,he[qe][Ze+2],!0),N.setUint16(nt+6*Oe,he[qe][Ze+3],!0),N.setUint16(nt+8*Oe,he[qe][Ze+4],!0),N.setUint16(nt+10*Oe,he[qe][Ze+5],!0),N.setUint16(nt+12*Oe,he[qe][Ze+6],!0),N.setUint16(nt+14*Oe,he[qe][Ze+7],!0),nt+=16*Oe}}if(Y!=se)for(let lt=8*Pe;lt<8*Pe+Ne;++lt){let Ot=Ye[qe][lt]+8*Y*2*Oe,Ze=Y*64+(lt&7)*8;for(let At=0;At<gt;++At)N.setUint16(Ot+At*2*Oe,he[qe][Ze+At],!0)}}}let ye=new Uint16Array(X);N=new DataView(U.buffer);for(let Pe=0;Pe<G;++Pe){S[_.idx[Pe]].decoded=!0;let Ne=S[_.idx[Pe]].type;if(S[Pe].type==2)for(let gt=0;gt<H;++gt){let nt=Ye[Pe][gt];for(let qe=0;qe<X;++qe)ye[qe]=N.getUint16(nt+qe*2*Ne,!0);for(let qe=0;qe<X;++qe)N.setFloat32(nt+qe*2*Ne,xe.fromHalfFloat(ye[qe]),!0)}}}function Xn(_,d,S,C,L,U){let N=new DataView(U.buffer),X=S[_],H=X.width,G=X.height,Y=Math.ceil(H/8),se=Math.ceil(G/8),Q=Math.floor(H/8),ee=H-(Y-1)*8,ue=G-(se-1)*8,de={value:0},pe=0,Te=new Float32Array(64),We=new Uint16Array(64),he=new Uint16Array(Y*64);for(let Ye=0;Ye<se;++Ye){let ye=8;Ye==se-1&&(ye=ue);for(let Pe=0;Pe<Y;++Pe)We.fill(0),We[0]=L[pe++],qt(de,C,We),_n(We,Te),yn(Te),It(Te,he,Pe*64);for(let Pe=8*Ye;Pe<8*Ye+ye;++Pe){let Ne=d[_][Pe];for(let gt=0;gt<Q;++gt){let nt=gt*64+(Pe&7)*8;for(let qe=0;qe<8;++qe)N.setUint16(Ne+qe*2*X.type,he[nt+qe],!0);Ne+=16*X.type}if(Y!=Q){let gt=Q*64+(Pe&7)*8;for(let nt=0;nt<ee;++nt)N.setUint16(Ne+nt*2*X.type,he[gt+nt],!0)}}}X.decoded=!0}function qt(_,d,S){let C,L=1;for(;L<64;)C=d[_.value],C==65280?L=64:C>>8==255?L+=C&255:(S[L]=C,L++),_.value++}function _n(_,d){d[0]=xe.fromHalfFloat(_[0]),d[1]=xe.fromHalfFloat(_[1]),d[2]=xe.fromHalfFloat(_[5]),d[3]=xe.fromHalfFloat(_[6]),d[4]=xe.fromHalfFloat(_[14]),d[5]=xe.fromHalfFloat(_[15]),d[6]=xe.fromHalfFloat(_[27]),d[7]=xe.fromHalfFloat(_[28]),d[8]=xe.fromHalfFloat(_[2]),d[9]=xe.fromHalfFloat(_[4]),d[10]=xe.fromHalfFloat(_[7]),d[11]=xe.fromHalfFloat(_[13]),d[12]=xe.fromHalfFloat(_[16]),d[13]=xe.fromHalfFloat(_[26]),d[14]=xe.fromHalfFloat(_[29]),d[15]=xe.fromHalfFloat(_[42]),d[16]=xe.fromHalfFloat(_[3]),d[17]=xe.fromHalfFloat(_[8]),d[18]=xe.fromHalfFloat(_[12]),d[19]=xe.fromHalfFloat(_[17]),d[20]=xe.fromHalfFloat(_[25]),d[21]=xe.fromHalfFloat(_[30]),d[22]=xe.fromHalfFloat(_[41]),d[23]=xe.fromHalfFloat(_[43]),d[24]=xe.fromHalfFloat(_[9]),d[25]=xe.fromHalfFloat(_[11]),d[26]=xe.fromHalfFloat(_[18]),d[27]=xe.fromHalfFloat(_[24]),d[28]=xe.fromHalfFloat(_[31]),d[29]=xe.fromHalfFloat(_[40]),d[30]=xe.fromHalfFloat(_[44]),d[31]=xe.fromHalfFloat(_[53]),d[32]=xe.fromHalfFloat(_[10]),d[33]=xe.fromHalfFloat(_[19]),d[34]=xe.fromHalfFloat(_[23]),d[35]=xe.fromHalfFloat(_[32]),d[36]=xe.fromHalfFloat(_[39]),d[37]=xe.fromHalfFloat(_[45]),d[38]=xe.fromHalfFloat(_[52]),d[39]=xe.fromHalfFloat(_[54]),d[40]=xe.fromHalfFloat(_[20]),d[41]=xe.fromHalfFloat(_[22]),d[42]=xe.fromHalfFloat(_[33]),d[43]=xe.fromHalfFloat(_[38]),d[44]=xe.fromHalfFloat(_[46]),d[45]=xe.fromHalfFloat(_[51]),d[46]=xe.fromHalfFloat(_[55]),d[47]=xe.fromHalfFloat(_[60]),d[48]=xe.fromHalfFloat(_[21]),d[49]=xe.fromHalfFloat(_[34]),d[50]=xe.fromHalfFloat(_[37]),d[51]=xe.fromHalfFloat(_[47]),d[52]=xe.fromHalfFloat(_[50]),d[53]=xe.fromHalfFloat(_[56]),d[54]=xe.fromHalfFloat(_[59]),d[55]=xe.fromHalfFloat(_[61]),d[56]=xe.fromHalfFloat(_[35]),d[57]=xe.fromHalfFloat(_[36]),d[58]=xe.fromHalfFloat(_[48]),d[59]=xe.fromHalfFloat(_[49]),d[60]=xe.fromHalfFloat(_[57]),d[61]=xe.fromHalfFloat(_[58]),d[62]=xe.fromHalfFloat(_[62]),d[63]=xe.fromHalfFloat(_[63])}function yn(_){let d=.5*Math.cos(.7853975),S=.5*Math.cos(3.14159/16),C=.5*Math.cos(3.14159/8),L=.5*Math.cos(3*3.14159/16),U=.5*Math.cos(5*3.14159/16),N=.5*Math.cos(3*3.14159/8),X=.5*Math.cos(7*3.14159/16),H=new Array(4),G=new Array(4),Y=new Array(4),se=new Array(4);for(let Q=0;Q<8;++Q){let ee=Q*8;H[0]=C*_[ee+2],H[1]=N*_[ee+2],H[2]=C*_[ee+6],H[3]=N*_[ee+6],G[0]=S*_[ee+1]+L*_[ee+3]+U*_[ee+5]+X*_[ee+7],G[1]=L*_[ee+1]-X*_[ee+3]-S*_[ee+5]-U*_[ee+7],G[2]=U*_[ee+1]-S*_[ee+3]+X*_[ee+5]+L*_[ee+7],G[3]=X*_[ee+1]-U*_[ee+3]+L*_[ee+5]-S*_[ee+7],Y[0]=d*(_[ee+0]+_[ee+4]),Y[3]=d*(_[ee+0]-_[ee+4]),Y[1]=H[0]+H[3],Y[2]=H[1]-H[2],se[0]=Y[0]+Y[1],se[1]=Y[3]+Y[2],se[2]=Y[3]-Y[2],se[3]=Y[0]-Y[1],_[ee+0]=se[0]+G[0],_[ee+1]=se[1]+G[1],_[ee+2]=se[2]+G[2],_[ee+3]=se[3]+G[3],_[ee+4]=se[3]-G[3],_[ee+5]=se[2]-G[2],_[ee+6]=se[1]-G[1],_[ee+7]=se[0]-G[0]}for(let Q=0;Q<8;++Q)H[0]=C*_[16+Q],H[1]=N*_[16+Q],H[2]=C*_[48+Q],H[3]=N*_[48+Q],G[0]=S*_[8+Q]+L*_[24+Q]+U*_[40+Q]+X*_[56+Q],G[1]=L*_[8+Q]-X*_[24+Q]-S*_[40+Q]-U*_[56+Q],G[2]=U*_[8+Q]-S*_[24+Q]+X*_[40+Q]+L*_[56+Q],G[3]=X*_[8+Q]-U*_[24+Q]+L*_[40+Q]-S*_[56+Q],Y[0]=d*(_[Q]+_[32+Q]),Y[3]=d*(_[Q]-_[32+Q]),Y[1]=H[0]+H[3],Y[2]=H[1]-H[2],se[0]=Y[0]+Y[1],se[1]=Y[3]+Y[2],se[2]=Y[3]-Y[2],se[3]=Y[0]-Y[1],_[0+Q]=se[0]+G[0],_[8+Q]=se[1]+G[1],_[16+Q]=se[2]+G[2],_[24+Q]=se[3]+G[3],_[32+Q]=se[3]-G[3],_[40+Q]=se[2]-G[2],_[48+Q]=se[1]-G[1],_[56+Q]=se[0]-G[0]}function An(_){for(let d=0;d<64;++d){let S=_[0][d],C=_[1][d],L=_[2][d];_[0][d]=S+1.5747*L,_[1][d]=S-.1873*C-.4682*L,_[2][d]=S+1.8556*C}}let V=new Float32Array(1),xn=new Uint32Array(V.buffer);function Ct(_){V[0]=_;let d=xn[0],S=d>>>16&32768,C=d&2147483647;if(C>=1199570944)return S|(C>2139095040?32256:31744);if(C<947912704)return V[0]=Math.abs(_)+.5,S|xn[0]-1056964608;let L=C+4095+(C>>>13&1);return S|L-939524096>>>13}function It(_,d,S){if(F===null){F=new Uint16Array(65536);for(let C=1;C<65536;++C){if((C&31744)===31744)continue;let L=xe.fromHalfFloat(C),U=Math.abs(L),N=U<=1?Math.pow(U,2.2):Math.pow(P,U-1);F[C]=Ct(L<0?-N:N)}}for(let C=0;C<64;++C)d[S+C]=F[Ct(_[C])]}function Ce(_){return new DataView(_.array.buffer,_.offset.value,_.size)}function Yt(_){let d=_.viewer.buffer.slice(_.offset.value,_.offset.value+_.size),S=new Uint8Array(on(d)),C=new Uint8Array(S.length);return Vt(S),kt(S,C),new DataView(C.buffer)}function Ge(_){let d=_.array.slice(_.offset.value,_.offset.value+_.size),S=ar(d),C=new Uint8Array(S.length);return Vt(S),kt(S,C),new DataView(C.buffer)}function je(_){let d=_.viewer,S={value:_.offset.value},C=new Uint16Array(_.columns*_.lines*(_.inputChannels.length*_.type)),L=new Uint8Array(8192),U=0,N=new Array(_.inputChannels.length);for(let ue=0,de=_.inputChannels.length;ue<de;ue++)N[ue]={},N[ue].start=U,N[ue].end=N[ue].start,N[ue].nx=_.columns,N[ue].ny=_.lines,N[ue].size=_.type,U+=N[ue].nx*N[ue].ny*N[ue].size;let X=ve(d,S),H=ve(d,S);if(H>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(X<=H)for(let ue=0;ue<H-X+1;ue++)L[ue+X]=k(d,S);let G=new Uint16Array(65536),Y=B(L,G),se=re(d,S);mt(_.array,d,S,se,C,U);for(let ue=0;ue<_.inputChannels.length;++ue){let de=N[ue];for(let pe=0;pe<N[ue].size;++pe)Ve(C,de.start+pe,de.nx,de.size,de.ny,de.nx*de.size,Y)}at(G,C,U);let Q=0,ee=new Uint8Array(C.buffer.byteLength);for(let ue=0;ue<_.lines;ue++)for(let de=0;de<_.inputChannels.length;de++){let pe=N[de],Te=pe.nx*pe.size,We=new Uint8Array(C.buffer,pe.end*2,Te*2);ee.set(We,Q),Q+=Te*2,pe.end+=Te}return new DataView(ee.buffer)}function O(_){let d=_.array.slice(_.offset.value,_.offset.value+_.size),S=ar(d),C=_.inputChannels.length*_.lines*_.columns*_.totalBytes,L=new ArrayBuffer(C),U=new DataView(L),N=0,X=0,H=new Array(4);for(let G=0;G<_.lines;G++)for(let Y=0;Y<_.inputChannels.length;Y++){let se=0;switch(_.inputChannels[Y].pixelType){case 1:H[0]=N,H[1]=H[0]+_.columns,N=H[1]+_.columns;for(let ee=0;ee<_.columns;++ee){let ue=S[H[0]++]<<8|S[H[1]++];se+=ue,U.setUint16(X,se,!0),X+=2}break;case 2:H[0]=N,H[1]=H[0]+_.columns,H[2]=H[1]+_.columns,N=H[2]+_.columns;for(let ee=0;ee<_.columns;++ee){let ue=S[H[0]++]<<24|S[H[1]++]<<16|S[H[2]++]<<8;se+=ue,U.setUint32(X,se,!0),X+=4}break}}return U}function R(_){let d=_.array,S=_.offset.value,C=_.columns,L=_.lines,U=_.inputChannels,N=_.totalBytes,X=an.compression==="B44A_COMPRESSION",H=new Uint8Array(L*C*N),G=new Uint16Array(16),Y=0;for(let se=0;se<U.length;se++){let Q=U[se],ee=Q.pixelType*2,ue=Math.ceil(C/Q.xSampling),de=Math.ceil(L/Q.ySampling),pe=Q.xSampling===1&&Q.ySampling===1;if(Q.pixelType!==1){for(let he=0;he<de;he++)if(pe){let Ye=he*C*N+Y*C;for(let ye=0;ye<ue*ee;ye++)H[Ye+ye]=d[S++]}else S+=ue*ee;Y+=ee;continue}let Te=Math.ceil(ue/4),We=Math.ceil(de/4);for(let he=0;he<We;he++)for(let Ye=0;Ye<Te;Ye++){if(X&&d[S+2]>=52){let ye=d[S]<<8|d[S+1],Pe=ye&32768?ye&32767:~ye&65535;G.fill(Pe),S+=3}else{let ye=d[S]<<8|d[S+1],Pe=d[S+2]>>2,Ne=32<<Pe,gt=ye+((d[S+2]<<4|d[S+3]>>4)&63)*(1<<Pe)-Ne&65535,nt=gt+((d[S+3]<<2|d[S+4]>>6)&63)*(1<<Pe)-Ne&65535,qe=nt+(d[S+4]&63)*(1<<Pe)-Ne&65535,Oe=ye+(d[S+5]>>2&63)*(1<<Pe)-Ne&65535,lt=gt+((d[S+5]<<4|d[S+6]>>4)&63)*(1<<Pe)-Ne&65535,Ot=nt+((d[S+6]<<2|d[S+7]>>6)&63)*(1<<Pe)-Ne&65535,Ze=qe+(d[S+7]&63)*(1<<Pe)-Ne&65535,At=Oe+(d[S+8]>>2&63)*(1<<Pe)-Ne&65535,fn=lt+((d[S+8]<<4|d[S+9]>>4)&63)*(1<<Pe)-Ne&65535,or=Ot+((d[S+9]<<2|d[S+10]>>6)&63)*(1<<Pe)-Ne&65535,di=Ze+(d[S+10]&63)*(1<<Pe)-Ne&65535,Tr=At+(d[S+11]>>2&63)*(1<<Pe)-Ne&65535,ma=fn+((d[S+11]<<4|d[S+12]>>4)&63)*(1<<Pe)-Ne&65535,ga=or+((d[S+12]<<2|d[S+13]>>6)&63)*(1<<Pe)-Ne&65535,va=di+(d[S+13]&63)*(1<<Pe)-Ne&65535,Ks=[ye,Oe,At,Tr,gt,lt,fn,ma,nt,Ot,or,ga,qe,Ze,di,va];for(let Qr=0;Qr<16;Qr++)G[Qr]=Ks[Qr]&32768?Ks[Qr]&32767:~Ks[Qr]&65535;S+=14}if(Q.pLinear){if(I===null){I=new Uint16Array(65536);for(let ye=0;ye<65536;ye++)if((ye&31744)===31744||ye>32768)I[ye]=0;else{let Pe=xe.fromHalfFloat(ye);I[ye]=Pe<=0?0:xe.toHalfFloat(8*Math.log(Pe))}}for(let ye=0;ye<16;ye++)G[ye]=I[G[ye]]}for(let ye=0;ye<4;ye++){let Pe=he*4+ye;if(!(Pe>=de))for(let Ne=0;Ne<4;Ne++){let gt=Ye*4+Ne;if(gt>=ue)continue;let nt=G[ye*4+Ne];for(let qe=0;qe<Q.ySampling;qe++){let Oe=Pe*Q.ySampling+qe;if(!(Oe>=L))for(let lt=0;lt<Q.xSampling;lt++){let Ot=gt*Q.xSampling+lt;if(Ot>=C)continue;let Ze=Oe*C*N+Y*C+Ot*2;H[Ze]=nt&255,H[Ze+1]=nt>>8&255}}}}}Y+=2}return new DataView(H.buffer)}function Z(_){let d=_.viewer,S={value:_.offset.value},C=new Uint8Array(_.columns*_.lines*(_.inputChannels.length*_.type*2)),L={version:ne(d,S),unknownUncompressedSize:ne(d,S),unknownCompressedSize:ne(d,S),acCompressedSize:ne(d,S),dcCompressedSize:ne(d,S),rleCompressedSize:ne(d,S),rleUncompressedSize:ne(d,S),rleRawSize:ne(d,S),totalAcUncompressedCount:ne(d,S),totalDcUncompressedCount:ne(d,S),acCompression:ne(d,S)};if(L.version<2)throw new Error("THREE.EXRLoader: "+an.compression+" version "+L.version+" is unsupported");let U=new Array,N=ve(d,S)-2;for(;N>0;){let de=ge(d.buffer,S),pe=k(d,S),Te=pe>>2&3,We=(pe>>4)-1,he=new Int8Array([We])[0],Ye=k(d,S);U.push({name:de,index:he,type:Ye,compression:Te}),N-=de.length+3}let X=an.channels,H=new Array(_.inputChannels.length);for(let de=0;de<_.inputChannels.length;++de){let pe=H[de]={},Te=X[de];pe.name=Te.name,pe.compression=0,pe.decoded=!1,pe.type=Te.pixelType,pe.pLinear=Te.pLinear,pe.width=_.columns,pe.height=_.lines}let G={idx:new Array(3)};for(let de=0;de<_.inputChannels.length;++de){let pe=H[de],Te=pe.name.lastIndexOf("."),We=Te>=0?pe.name.substring(Te+1):pe.name;for(let he=0;he<U.length;++he){let Ye=U[he];We===Ye.name&&pe.type===Ye.type&&(pe.compression=Ye.compression,Ye.index>=0&&(G.idx[Ye.index]=de),pe.offset=de)}}let Y,se,Q;if(L.acCompressedSize>0)switch(L.acCompression){case 0:Y=new Uint16Array(L.totalAcUncompressedCount),mt(_.array,d,S,L.acCompressedSize,Y,L.totalAcUncompressedCount);break;case 1:let de=_.array.slice(S.value,S.value+L.totalAcUncompressedCount),pe=ar(de);Y=new Uint16Array(pe.buffer),S.value+=L.totalAcUncompressedCount;break}if(L.dcCompressedSize>0){let de={array:_.array,offset:S,size:L.dcCompressedSize};se=new Uint16Array(Ge(de).buffer),S.value+=L.dcCompressedSize}if(L.rleRawSize>0){let de=_.array.slice(S.value,S.value+L.rleCompressedSize),pe=ar(de);Q=on(pe.buffer),S.value+=L.rleCompressedSize}let ee=0,ue=new Array(H.length);for(let de=0;de<ue.length;++de)ue[de]=new Array;for(let de=0;de<_.lines;++de)for(let pe=0;pe<H.length;++pe)ue[pe].push(ee),ee+=H[pe].width*_.type*2;G.idx[0]!==void 0&&H[G.idx[0]]&&Ut(G,ue,H,Y,se,C);for(let de=0;de<H.length;++de){let pe=H[de];if(!pe.decoded)switch(pe.compression){case 2:let Te=0,We=0;for(let he=0;he<_.lines;++he){let Ye=ue[de][Te];for(let ye=0;ye<pe.width;++ye){for(let Pe=0;Pe<2*pe.type;++Pe)C[Ye++]=Q[We+Pe*pe.width*pe.height];We++}Te++}break;case 1:Xn(de,ue,H,Y,se,C);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(C.buffer)}function ge(_,d){let S=new Uint8Array(_),C=0;for(;S[d.value+C]!=0;)C+=1;let L=new TextDecoder().decode(S.slice(d.value,d.value+C));return d.value=d.value+C+1,L}function le(_,d,S){let C=new TextDecoder().decode(new Uint8Array(_).slice(d.value,d.value+S));return d.value=d.value+S,C}function be(_,d){let S=te(_,d),C=re(_,d);return[S,C]}function Ie(_,d){let S=re(_,d),C=re(_,d);return[S,C]}function te(_,d){let S=_.getInt32(d.value,!0);return d.value=d.value+4,S}function re(_,d){let S=_.getUint32(d.value,!0);return d.value=d.value+4,S}function Me(_,d){let S=_[d.value];return d.value=d.value+1,S}function k(_,d){let S=_.getUint8(d.value);return d.value=d.value+1,S}let ne=function(_,d){let S=Number(_.getBigInt64(d.value,!0));return d.value+=8,S};function j(_,d){let S=_.getFloat32(d.value,!0);return d.value+=4,S}function Ae(_,d){return xe.toHalfFloat(j(_,d))}function ve(_,d){let S=_.getUint16(d.value,!0);return d.value+=2,S}function Se(_,d){return xe.fromHalfFloat(ve(_,d))}function Be(_,d,S,C){let L=S.value,U=[];for(;S.value<L+C-1;){let N=ge(d,S),X=te(_,S),H=k(_,S);S.value+=3;let G=te(_,S),Y=te(_,S);U.push({name:N,pixelType:X,pLinear:H,xSampling:G,ySampling:Y})}return S.value+=1,U}function tt(_,d){let S=j(_,d),C=j(_,d),L=j(_,d),U=j(_,d),N=j(_,d),X=j(_,d),H=j(_,d),G=j(_,d);return{redX:S,redY:C,greenX:L,greenY:U,blueX:N,blueY:X,whiteX:H,whiteY:G}}function _e(_,d){let S=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],C=k(_,d);return S[C]}function He(_,d){let S=te(_,d),C=te(_,d),L=te(_,d),U=te(_,d);return{xMin:S,yMin:C,xMax:L,yMax:U}}function Qe(_,d){let S=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],C=k(_,d);return S[C]}function Le(_,d){let S=["ENVMAP_LATLONG","ENVMAP_CUBE"],C=k(_,d);return S[C]}function vt(_,d){let S=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],C=["ROUND_DOWN","ROUND_UP"],L=re(_,d),U=re(_,d),N=k(_,d);return{xSize:L,ySize:U,levelMode:S[N&15],roundingMode:C[N>>4]}}function jt(_,d){let S=j(_,d),C=j(_,d);return[S,C]}function ui(_,d){let S=j(_,d),C=j(_,d),L=j(_,d);return[S,C,L]}function la(_,d,S,C,L){if(C==="string"||C==="stringvector"||C==="iccProfile")return le(d,S,L);if(C==="chlist")return Be(_,d,S,L);if(C==="chromaticities")return tt(_,S);if(C==="compression")return _e(_,S);if(C==="box2i")return He(_,S);if(C==="envmap")return Le(_,S);if(C==="tiledesc")return vt(_,S);if(C==="lineOrder")return Qe(_,S);if(C==="float")return j(_,S);if(C==="v2f")return jt(_,S);if(C==="v3f")return ui(_,S);if(C==="int")return te(_,S);if(C==="rational")return be(_,S);if(C==="timecode")return Ie(_,S);if(C==="preview"||C==="deepImageState"||C==="idmanifest")return S.value+=L,"skipped";S.value+=L}function Xs(_,d){let S=Math.log2(_);return d=="ROUND_DOWN"?Math.floor(S):Math.ceil(S)}function nh(_,d,S){let C=0;switch(_.levelMode){case"ONE_LEVEL":C=1;break;case"MIPMAP_LEVELS":C=Xs(Math.max(d,S),_.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return C}function qs(_,d,S,C){let L=new Array(_);for(let U=0;U<_;U++){let N=1<<U,X=d/N|0;C=="ROUND_UP"&&X*N<d&&(X+=1);let H=Math.max(X,1);L[U]=(H+S-1)/S|0}return L}function ca(){let _=this,d=_.offset,S={value:0};for(let C=0;C<_.tileCount;C++){let L=te(_.viewer,d),U=te(_.viewer,d);d.value+=8,_.size=re(_.viewer,d);let N=L*_.blockWidth,X=U*_.blockHeight;_.columns=N+_.blockWidth>_.width?_.width-N:_.blockWidth,_.lines=X+_.blockHeight>_.height?_.height-X:_.blockHeight;let H=_.columns*_.totalBytes,Y=_.size<_.lines*H?_.uncompress(_):Ce(_);d.value+=_.size;for(let se=0;se<_.lines;se++){let Q=se*_.columns*_.totalBytes;for(let ee=0;ee<_.inputChannels.length;ee++){let ue=an.channels[ee].name,de=_.channelByteOffsets[ue]*_.columns,pe=_.decodeChannels[ue];if(pe===void 0)continue;S.value=Q+de;let Te=(_.height-(1+X+se))*_.outLineWidth;for(let We=0;We<_.columns;We++){let he=Te+(We+N)*_.outputChannels+pe;_.byteArray[he]=_.getter(Y,S)}}}}}function Ii(){let _=this,d=_.offset,S={value:0};for(let C=0;C<_.height/_.blockHeight;C++){let L=te(_.viewer,d)-an.dataWindow.yMin;_.size=re(_.viewer,d),_.lines=L+_.blockHeight>_.height?_.height-L:_.blockHeight;let U=_.columns*_.totalBytes,X=_.size<_.lines*U?_.uncompress(_):Ce(_);d.value+=_.size;for(let H=0;H<_.lines;H++){let G=L+H,Y=H*U,se=(_.height-1-G)*_.outLineWidth;for(let Q=0;Q<_.inputChannels.length;Q++){let ee=an.channels[Q].name,ue=_.channelByteOffsets[ee]*_.columns,de=_.decodeChannels[ee];if(de!==void 0){S.value=Y+ue;for(let pe=0;pe<_.columns;pe++){let Te=se+pe*_.outputChannels+de;_.byteArray[Te]=_.getter(X,S)}}}}}}function Ys(){let _=this,d=_.chunkOffsets,S={value:0};for(let C=0;C<d.length;C++){let L={value:d[C]};L.value+=4;let U=te(_.viewer,L)-an.dataWindow.yMin;_.size=re(_.viewer,L),_.lines=U+_.blockHeight>_.height?_.height-U:_.blockHeight;let N=_.columns*_.totalBytes,X=_.size<_.lines*N,H=_.offset;_.offset=L;let G=X?_.uncompress(_):Ce(_);_.offset=H;for(let Y=0;Y<_.lines;Y++){let se=U+Y,Q=Y*N,ee=(_.height-1-se)*_.outLineWidth;for(let ue=0;ue<_.inputChannels.length;ue++){let de=an.channels[ue].name,pe=_.channelByteOffsets[de]*_.columns,Te=_.decodeChannels[de];if(Te!==void 0){S.value=Q+pe;for(let We=0;We<_.columns;We++){let he=ee+We*_.outputChannels+Te;_.byteArray[he]=_.getter(G,S)}}}}}}function Zs(_,d,S,C){if(S===0)return null;let L=_.slice(d,d+S);switch(C){case"NO_COMPRESSION":return new DataView(L.buffer,L.byteOffset,L.byteLength);case"RLE_COMPRESSION":{let U=new Uint8Array(on(L.buffer.slice(L.byteOffset,L.byteOffset+L.byteLength))),N=new Uint8Array(U.length);return Vt(U),kt(U,N),new DataView(N.buffer)}case"ZIPS_COMPRESSION":{let U=ar(L),N=new Uint8Array(U.length);return Vt(U),kt(U,N),new DataView(N.buffer)}default:throw new Error("THREE.EXRLoader: "+C+" is unsupported for deep data")}}function ha(){let _=this,d=_.chunkOffsets,S=_.width,C=_.height,L=_.deepChannels,U=an.compression,N=_.multiPart,X=_.decodeChannels,H=_.outputChannels,G=_.byteArray instanceof Uint16Array,Y=-1;for(let se=0;se<L.length;se++)if(L[se].name==="A"){Y=se;break}for(let se=0;se<d.length;se++){let Q={value:d[se]};N&&(Q.value+=4);let ee=te(_.viewer,Q)-an.dataWindow.yMin,ue=ne(_.viewer,Q),de=ne(_.viewer,Q);ne(_.viewer,Q);let pe=Zs(_.array,Q.value,ue,U);if(Q.value+=ue,pe===null)continue;let Te=new Uint32Array(S);for(let Ne=0;Ne<S;Ne++)Te[Ne]=pe.getUint32(Ne*4,!0);let We=Te[S-1];if(We===0){Q.value+=de;continue}let he=Zs(_.array,Q.value,de,U),Ye=[],ye=0;for(let Ne=0;Ne<L.length;Ne++)Ye.push(ye),ye+=We*L[Ne].bytesPerSample;let Pe=(C-1-ee)*_.outLineWidth;for(let Ne=0;Ne<S;Ne++){let gt=Ne===0?0:Te[Ne-1],qe=Te[Ne]-gt;if(qe===0)continue;let Oe=new Float32Array(H),lt=0;for(let Ze=0;Ze<qe;Ze++){let At=gt+Ze,fn=1-lt;if(fn<=0)break;let or=1;if(Y>=0){let di=L[Y].bytesPerSample,Tr=Ye[Y]+At*di;or=di===2?xe.fromHalfFloat(he.getUint16(Tr,!0)):he.getFloat32(Tr,!0)}for(let di=0;di<L.length;di++){let Tr=L[di],ma=X[Tr.name];if(ma===void 0)continue;let ga=Tr.bytesPerSample,va=Ye[di]+At*ga,Ks=ga===2?xe.fromHalfFloat(he.getUint16(va,!0)):he.getFloat32(va,!0);Oe[ma]+=Ks*fn}lt+=or*fn}X.A!==void 0&&(Oe[X.A]=lt);let Ot=Pe+Ne*H;for(let Ze=0;Ze<H;Ze++)_.byteArray[Ot+Ze]=G?xe.toHalfFloat(Oe[Ze]):Oe[Ze]}}}function wr(_,d,S){let C={},L=!1;for(;;){let U=ge(d,S);if(U==="")break;L=!0;let N=ge(d,S),X=re(_,S),H=la(_,d,S,N,X);H===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${N}'.`):C[U]=H}return L?C:null}function ua(_,d,S){if(_.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let C=_.getUint8(4),L=_.getUint8(5),U={singleTile:!!(L&2),longName:!!(L&4),deepFormat:!!(L&8),multiPart:!!(L&16)};S.value=8;let N=[];if(U.multiPart){for(;;){let X=wr(_,d,S);if(X===null)break;X.version=C,X.spec=U,N.push(X)}if(N.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let X=wr(_,d,S);X.version=C,X.spec=U,N.push(X)}return N}function fa(_,d,S,C,L,U){let N={size:0,viewer:d,array:S,offset:C,width:_.dataWindow.xMax-_.dataWindow.xMin+1,height:_.dataWindow.yMax-_.dataWindow.yMin+1,inputChannels:_.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Lt};switch(_.compression){case"NO_COMPRESSION":N.blockHeight=1,N.uncompress=Ce;break;case"RLE_COMPRESSION":N.blockHeight=1,N.uncompress=Yt;break;case"ZIPS_COMPRESSION":N.blockHeight=1,N.uncompress=Ge;break;case"ZIP_COMPRESSION":N.blockHeight=16,N.uncompress=Ge;break;case"PIZ_COMPRESSION":N.blockHeight=32,N.uncompress=je;break;case"PXR24_COMPRESSION":N.blockHeight=16,N.uncompress=O;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":N.blockHeight=32,N.uncompress=R;break;case"DWAA_COMPRESSION":N.blockHeight=32,N.uncompress=Z;break;case"DWAB_COMPRESSION":N.blockHeight=256,N.uncompress=Z;break;default:throw new Error("THREE.EXRLoader: "+_.compression+" is unsupported")}let X={};for(let Q of _.channels)switch(Q.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":X[Q.name]=!0,N.type=Q.pixelType}let H=!1,G=!1;if(X.Y&&X.RY&&X.BY)N.outputChannels=4,N.yCbCr=!0;else if(X.R&&X.G&&X.B)N.outputChannels=4;else if(X.Y)N.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(N.outputChannels){case 4:U==xt?(H=!X.A,N.format=xt,N.colorSpace=Lt,N.outputChannels=4,N.decodeChannels={R:0,G:1,B:2,A:3}):U==Fn?(N.format=Fn,N.colorSpace=Lt,N.outputChannels=2,N.decodeChannels={R:0,G:1}):U==nr?(N.format=nr,N.colorSpace=Lt,N.outputChannels=1,N.decodeChannels={R:0}):G=!0;break;case 1:U==xt?(H=!0,N.format=xt,N.colorSpace=Lt,N.outputChannels=4,N.shouldExpand=!0,N.decodeChannels={Y:0}):U==Fn?(N.format=Fn,N.colorSpace=Lt,N.outputChannels=2,N.shouldExpand=!0,N.decodeChannels={Y:0}):U==nr?(N.format=nr,N.colorSpace=Lt,N.outputChannels=1,N.decodeChannels={Y:0}):G=!0;break;default:G=!0}if(G)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(N.yCbCr&&(N.format=xt,N.outputChannels=4,N.decodeChannels={Y:0,RY:1,BY:2},H=!0),N.type==1)switch(L){case yt:N.getter=Se;break;case Jt:N.getter=ve;break}else if(N.type==2)switch(L){case yt:N.getter=j;break;case Jt:N.getter=Ae}else throw new Error("THREE.EXRLoader: unsupported pixelType "+N.type+" for "+_.compression+".");N.columns=N.width;let Y=N.width*N.height*N.outputChannels;switch(L){case yt:N.byteArray=new Float32Array(Y),H&&N.byteArray.fill(1,0,Y);break;case Jt:N.byteArray=new Uint16Array(Y),H&&N.byteArray.fill(15360,0,Y);break;default:console.error("THREE.EXRLoader: unsupported type: ",L);break}let se=0;for(let Q of _.channels)N.decodeChannels[Q.name]!==void 0&&(N.channelByteOffsets[Q.name]=se),se+=Q.pixelType*2;if(N.totalBytes=se,N.outLineWidth=N.width*N.outputChannels,_.spec.deepFormat){N.deepChannels=[];let Q=0;for(let ee of _.channels){let ue=ee.pixelType===0?4:ee.pixelType*2;N.deepChannels.push({name:ee.name,pixelType:ee.pixelType,bytesPerSample:ue}),Q+=ue}N.deepBytesPerSample=Q,N.chunkOffsets=_._chunkOffsets,N.multiPart=_.spec.multiPart,N.decode=ha.bind(N)}else if(_.spec.singleTile){N.blockHeight=_.tiles.ySize,N.blockWidth=_.tiles.xSize;let Q=nh(_.tiles,N.width,N.height),ee=qs(Q,N.width,_.tiles.xSize,_.tiles.roundingMode),ue=qs(Q,N.height,_.tiles.ySize,_.tiles.roundingMode);N.tileCount=ee[0]*ue[0];for(let de=0;de<Q;de++)for(let pe=0;pe<ue[de];pe++)for(let Te=0;Te<ee[de];Te++)ne(d,C);N.decode=ca.bind(N)}else if(_.spec.multiPart)N.blockWidth=N.width,N.chunkOffsets=_._chunkOffsets,N.decode=Ys.bind(N);else{N.blockWidth=N.width;let Q=Math.ceil(N.height/N.blockHeight);for(let ee=0;ee<Q;ee++)ne(d,C);N.decode=Ii.bind(N)}return N}let fi={value:0},jr=new DataView(e),da=new Uint8Array(e),Ar=ua(jr,e,fi),pa=Math.max(0,Math.min(this.part,Ar.length-1)),an=Ar[pa];if(an.spec.multiPart||an.spec.deepFormat)for(let _=0;_<Ar.length;_++){let d=Ar[_].chunkCount;if(_===pa){an._chunkOffsets=[];for(let S=0;S<d;S++)an._chunkOffsets.push(ne(jr,fi))}else for(let S=0;S<d;S++)ne(jr,fi)}let Tn=fa(an,jr,da,fi,this.type,this.outputFormat);if(Tn.decode(),Tn.shouldExpand){let _=Tn.byteArray;if(this.outputFormat==xt)for(let d=0;d<_.length;d+=4)_[d+2]=_[d+1]=_[d];else if(this.outputFormat==Fn)for(let d=0;d<_.length;d+=2)_[d+1]=_[d]}if(Tn.yCbCr){let _=Tn.byteArray,d=Tn.width*Tn.height;if(this.type===Jt)for(let S=0;S<d;S++){let C=S*4,L=xe.fromHalfFloat(_[C]),U=xe.fromHalfFloat(_[C+1]),N=xe.fromHalfFloat(_[C+2]),X=(1+U)*L,H=(1+N)*L,G=(L-X*.2126-H*.0722)/.7152;_[C]=xe.toHalfFloat(Math.max(0,X)),_[C+1]=xe.toHalfFloat(Math.max(0,G)),_[C+2]=xe.toHalfFloat(Math.max(0,H))}else for(let S=0;S<d;S++){let C=S*4,L=_[C],U=_[C+1],N=_[C+2],X=(1+U)*L,H=(1+N)*L;_[C]=Math.max(0,X),_[C+1]=Math.max(0,(L-X*.2126-H*.0722)/.7152),_[C+2]=Math.max(0,H)}}return{header:an,width:Tn.width,height:Tn.height,data:Tn.byteArray,format:Tn.format,colorSpace:Tn.colorSpace,type:this.type,minFilter:Rt,magFilter:Rt,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var Fc=class extends Gr{constructor(e){super(e),this.type=Jt}parse(e){let o=function(b,P){switch(b){case 1:throw new Error("THREE.HDRLoader: Read Error: "+(P||""));case 2:throw new Error("THREE.HDRLoader: Write Error: "+(P||""));case 3:throw new Error("THREE.HDRLoader: Bad File Format: "+(P||""));default:case 4:throw new Error("THREE.HDRLoader: Memory Error: "+(P||""))}},u=function(b,P,I){P=P||1024;let B=b.pos,z=-1,D=0,$="",q=String.fromCharCode.apply(null,new Uint16Array(b.subarray(B,B+128)));for(;0>(z=q.indexOf(`
`))&&D<P&&B<b.byteLength;)$+=q,D+=q.length,B+=128,q=String.fromCharCode.apply(null,new Uint16Array(b.subarray(B,B+128)));return-1<z?(I!==!1&&(b.pos+=D+z+1),$+q.slice(0,z)):!1},f=function(b){let P=/^#\?(\S+)/,I=/^\s*GAMMA\s*=\s*(\d+(\.\d+)?)\s*$/,F=/^\s*EXPOSURE\s*=\s*(\d+(\.\d+)?)\s*$/,B=/^\s*FORMAT=(\S+)\s*$/,z=/^\s*\-Y\s+(\d+)\s+\+X\s+(\d+)\s*$/,D={valid:0,string:"",comments:"",programtype:"RGBE",format:"",gamma:1,exposure:1,width:0,height:0},$,q;for((b.pos>=b.byteLength||!($=u(b)))&&o(1,"no header found"),(q=$.match(P))||o(3,"bad initial token"),D.valid|=1,D.programtype=q[1],D.string+=$+`
`;$=u(b),$!==!1;){if(D.string+=$+`
`,$.charAt(0)==="#"){D.comments+=$+`
`;continue}if((q=$.match(I))&&(D.gamma=parseFloat(q[1])),(q=$.match(F))&&(D.exposure=parseFloat(q[1])),(q=$.match(B))&&(D.valid|=2,D.format=q[1]),(q=$.match(z))&&(D.valid|=4,D.height=parseInt(q[1],10),D.width=parseInt(q[2],10)),D.valid&2&&D.valid&4)break}return D.valid&2||o(3,"missing format specifier"),D.valid&4||o(3,"missing image size specifier"),D},p=function(b,P,I){let F=P;if(F<8||F>32767||b[0]!==2||b[1]!==2||b[2]&128)return new Uint8Array(b);F!==(b[2]<<8|b[3])&&o(3,"wrong scanline width");let B=new Uint8Array(4*P*I);B.length||o(4,"unable to allocate buffer space");let z=0,D=0,$=4*F,q=new Uint8Array(4),K=new Uint8Array($),fe=I;for(;fe>0&&D<b.byteLength;){D+4>b.byteLength&&o(1),q[0]=b[D++],q[1]=b[D++],q[2]=b[D++],q[3]=b[D++],(q[0]!=2||q[1]!=2||(q[2]<<8|q[3])!=F)&&o(3,"bad rgbe scanline format");let J=0,ae;for(;J<$&&D<b.byteLength;){ae=b[D++];let we=ae>128;if(we&&(ae-=128),(ae===0||J+ae>$)&&o(3,"bad scanline data"),we){let De=b[D++];for(let ie=0;ie<ae;ie++)K[J++]=De}else K.set(b.subarray(D,D+ae),J),J+=ae,D+=ae}let ce=F;for(let we=0;we<ce;we++){let De=0;B[z]=K[we+De],De+=F,B[z+1]=K[we+De],De+=F,B[z+2]=K[we+De],De+=F,B[z+3]=K[we+De],z+=4}fe--}return B},v=function(b,P,I,F){let B=b[P+3],z=Math.pow(2,B-128)/255;I[F+0]=b[P+0]*z,I[F+1]=b[P+1]*z,I[F+2]=b[P+2]*z,I[F+3]=1},y=function(b,P,I,F){let B=b[P+3],z=Math.pow(2,B-128)/255;I[F+0]=xe.toHalfFloat(Math.min(b[P+0]*z,65504)),I[F+1]=xe.toHalfFloat(Math.min(b[P+1]*z,65504)),I[F+2]=xe.toHalfFloat(Math.min(b[P+2]*z,65504)),I[F+3]=xe.toHalfFloat(1)},m=new Uint8Array(e);m.pos=0;let g=f(m),A=g.width,M=g.height,w=p(m.subarray(m.pos),A,M),T,E,x;switch(this.type){case yt:x=w.length/4;let b=new Float32Array(x*4);for(let I=0;I<x;I++)v(w,I*4,b,I*4);T=b,E=yt;break;case Jt:x=w.length/4;let P=new Uint16Array(x*4);for(let I=0;I<x;I++)y(w,I*4,P,I*4);T=P,E=Jt;break;default:throw new Error("THREE.HDRLoader: Unsupported type: "+this.type)}return{width:A,height:M,data:T,header:g.string,gamma:g.gamma,exposure:g.exposure,type:E,colorSpace:Lt,minFilter:Rt,magFilter:Rt,generateMipmaps:!1,flipY:!0}}setDataType(e){return this.type=e,this}};var pt=128,Et=64,rr=1024,NS=.5;function Vs(i){let e=new Float32Array(3*pt*Et);for(let t=0;t<Et;t+=1)for(let n=0;n<pt;n+=1)e.set(DS(i,Mg((n+.5)/pt,(t+.5)/Et)),3*(t*pt+n));return e}function Mg(i,e){let[t,n]=[2*Math.PI*i,Math.PI*e];return[Math.sin(n)*Math.sin(t),Math.cos(n),Math.sin(n)*Math.cos(t)]}function DS(i,e){return i==="dome"?[1,1,1]:i==="sky"?FS(e):i==="studio"?kS(e):[0,0,0]}var Kr=(i,e,t)=>{let n=Math.min(Math.max((t-i)/(e-i),0),1);return n*n*(3-2*n)},Uc=(i,e,t)=>[i[0]+t*(e[0]-i[0]),i[1]+t*(e[1]-i[1]),i[2]+t*(e[2]-i[2])],oa=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Cf=i=>{let e=Math.hypot(...i);return[i[0]/e,i[1]/e,i[2]/e]};function FS(i){let e=Uc([1,.98,.94],[.28,.47,.86],Kr(0,.75,i[1])),t=Uc(Uc([.3,.27,.23],[.5,.47,.43],Kr(-.5,0,i[1])),e,Kr(-.05,.05,i[1])),n=Cf([.75,.55,.5]),r=Math.exp(-((1-oa(i,n))/.03))*9+Math.exp(-((1-oa(i,n))/.25))*.5,s=Kr(-.05,.1,i[1]);return[t[0]+1*r*s,t[1]+.88*r*s,t[2]+.7*r*s]}function If(i,e,t){let n=Cf(i),r=Cf([n[2],0,-n[0]]),s=[n[1]*r[2]-n[2]*r[1],n[2]*r[0]-n[0]*r[2],n[0]*r[1]-n[1]*r[0]];return o=>{let a=oa(o,n);if(a<=0)return 0;let l=Math.abs(oa(o,r))/a;return l>=1.1*e?0:(1-Kr(.8,1.1,l/e))*(1-Kr(.8,1.1,Math.abs(oa(o,s))/a/t))}}var US=If([-.8,.75,.6],.55,.4),OS=If([1,.25,.15],.16,.7),BS=If([.3,.8,-1],.7,.22);function kS(i){let e=Uc([.06,.055,.05],[.16,.165,.18],Kr(-.4,1,i[1])),t=4.2*US(i),n=3*OS(i),r=4*BS(i);return[e[0]+1*t+.85*n+.95*r,e[1]+.96*t+.93*n+.97*r,e[2]+.88*t+1.05*n+1*r]}var Pf=(i,e)=>.2126*i[3*e]+.7152*i[3*e+1]+.0722*i[3*e+2];function Sg(i){let e=0;for(let t=0;t<Et/2;t+=1){let[n,r]=[Math.cos(Math.PI*t/Et),Math.cos(Math.PI*(t+1)/Et)],s=(n*n-r*r)/pt;for(let o=0;o<pt;o+=1)e+=s*Pf(i,t*pt+o)}return e}function zS(i){let e=0;for(let t=0;t<pt*Et;t+=1)e+=Pf(i,t)*Math.sin(Math.PI*(Math.floor(t/pt)+.5)/Et);return e*Math.PI/(2*Et*pt)}function HS(i){let e=NS*zS(i),t=new Float32Array(8*rr),n=new Float64Array(pt*Et),r=new Float64Array(Et+1);for(let a=0;a<Et;a+=1){let l=2*Math.PI/pt*(Math.cos(Math.PI*a/Et)-Math.cos(Math.PI*(a+1)/Et)),c=0;for(let h=0;h<pt;h+=1){let u=a*pt+h;n[u]=l*(Pf(i,u)+e),c+=n[u]}r[a+1]=r[a]+c}let s=r[Et];if(!(s>0))return t;let o=1.324717957244746;for(let a=0;a<rr;a+=1){let l=(.5+(a+1)/o)%1,c=(.5+(a+1)/(o*o))%1,h=0;for(;h<Et-1&&r[h+1]<l*s;)h+=1;let u=(l*s-r[h])/(r[h+1]-r[h]||1),f=0,p=0,v=c*(r[h+1]-r[h]);for(;f<pt-1&&p+n[h*pt+f]<v;)p+=n[h*pt+f],f+=1;let y=h*pt+f,m=(v-p)/(n[y]||1),[g,A]=[Math.cos(Math.PI*h/Et),Math.cos(Math.PI*(h+1)/Et)],M=Math.acos(g+u*(A-g)),T=2*Math.PI/pt*(g-A)*s/n[y];t.set(Mg((f+m)/pt,M/Math.PI),8*a),t.set([i[3*y]*T,i[3*y+1]*T,i[3*y+2]*T],8*a+4)}return t}function wg(i){let e=new gn(HS(i),256,2*rr/256,xt,yt);return e.needsUpdate=!0,e}var Tg=[".hdr",".exr"],Lf=2**25,Ag=512*2**20,Eg=65536;function Rg(i,e){if(e.byteLength>Ag)throw new oe(`${i} has ${Math.round(e.byteLength/2**20)} MiB, more than ${Ag/2**20}`,"Make it smaller: the sky is shown in 64 x 128 cells");let t=i.toLowerCase().endsWith(".exr"),[n,r]=t?VS(i,e):GS(i,e);if(!(n>0&&r>0&&n*r<=Lf))throw new oe(`${i} claims ${n} x ${r} pixels, which is none or more than ${Lf.toLocaleString("en")}`,"Make it smaller: the sky is shown in 64 x 128 cells");if(Math.abs(n/r-2)>.05)throw new oe(`${i} has ${n} x ${r} pixels; a panorama is twice as wide as high`,"Open an equirectangular (latitude and longitude) picture");let s;try{s=(t?new Dc:new Fc).parse(e)}catch(o){throw new oe(`${i} is not a picture that can be read: ${o instanceof Error?o.message:String(o)}`,"Save it again as Radiance HDR or OpenEXR")}if(s.width!==n||s.height!==r)throw new oe(`${i} holds ${s.width} x ${s.height} pixels where its head says ${n} x ${r}`,"The file is damaged");return WS(i,s.data,n,r,t)}function GS(i,e){let t=new TextDecoder("latin1").decode(e.slice(0,Eg)),n=/\n-Y (\d+) \+X (\d+)\n/.exec(t);if(!t.startsWith("#?")||!n)throw new oe(`${i} has no head of a Radiance picture that is stored row by row from the top`,"Save it again as Radiance HDR or OpenEXR");let[r,s]=[Number(n[2]),Number(n[1])];if(e.byteLength-t.indexOf(n[0])-n[0].length<s*Math.min(4*r,4+8*Math.ceil(r/127))&&r*s<=Lf)throw new oe(`${i} breaks off within its pixels`,"The file is damaged; fetch it again");return[r,s]}function VS(i,e){let t=new TextDecoder("latin1").decode(e.slice(0,Eg)),n=t.indexOf("dataWindow\0box2i\0");if(!t.startsWith("v/1")||n<0||n+37>e.byteLength)throw new oe(`${i} has no head of an OpenEXR picture`,"Save it again as Radiance HDR or OpenEXR");let[r,s,o,a]=[0,1,2,3].map(l=>new DataView(e).getInt32(n+21+4*l,!0));return[o-r+1,a-s+1]}function WS(i,e,t,n,r){let s=e.length/(t*n),o=(h,u,f)=>{let p=e[((r?n-1-u:u)*t+h)*s+(s<3?0:f)],v=e instanceof Uint16Array?xe.fromHalfFloat(p):p;return Number.isFinite(v)&&v>0?v:0},a=new Float64Array(3*pt*Et),l=new Float64Array(pt*Et);for(let h=0;h<n;h+=1){let u=Math.sin(Math.PI*(h+.5)/n),f=Math.min(Math.floor((h+.5)*Et/n),Et-1);for(let p=0;p<t;p+=1){let v=f*pt+$S((p+.5)/t);l[v]+=u;for(let y=0;y<3;y+=1)a[3*v+y]+=u*o(p,h,y)}}let c=new Float32Array(3*pt*Et);for(let h=0;h<pt*Et;h+=1){let u=l[h],f=Math.min(Math.floor((1-(h%pt+.5)/pt)%1*t),t-1),p=Math.min(Math.floor((Math.floor(h/pt)+.5)*n/Et),n-1);for(let v=0;v<3;v+=1)c[3*h+v]=u>0?a[3*h+v]/u:o(f,p,v)}if(!c.some(h=>h>0))throw new oe(`${i} is black`,"Open a picture with light in it");return c}function $S(i){return Math.min(Math.floor((1-i)*pt),pt-1)}var Cg=256*2**20;async function Ig(i,e,t=!1){let n=i.name.toLowerCase(),r=n.slice(n.lastIndexOf("."));if(xg.includes(r)){await e.openMesh(i.name,await i.arrayBuffer());return}if(Tg.includes(r)){e.openSky(i.name,Rg(i.name,await i.arrayBuffer()));return}if(![".json",".csv",".txt",".tsv",".dat"].includes(r))throw new oe(`${i.name} is neither a material, a table, a mesh nor a sky`,"Drop a .json, .csv, .obj, .ply, .glb, .hdr or .exr file");if(i.size>Cg)throw new oe(`${i.name} has ${Math.round(i.size/2**20)} MiB, more than ${Cg/2**20}`,"motes view DATA thins any measurement");let s=wd(await i.arrayBuffer());r===".json"?e.openMaterial(XS(i.name,s),t):e.openData(Hd(i.name,s))}function XS(i,e){try{return JSON.parse(e)}catch(t){throw new oe(`${i} is not JSON: ${t instanceof Error?t.message:String(t)}`,"Drop a material.json that motes fit wrote; NaN is not JSON")}}function Pg(i,e,t){i.addEventListener("dragover",n=>{n.preventDefault(),i.classList.add("motes-over")},{signal:t}),i.addEventListener("dragleave",()=>i.classList.remove("motes-over"),{signal:t}),i.addEventListener("drop",n=>{n.preventDefault(),i.classList.remove("motes-over");for(let r of Array.from(n.dataTransfer?.files??[]))Ig(r,e,n.shiftKey).catch(e.messages.fail)},{signal:t})}function Nf(i,e,t,n){let r=Ee("input",{type:"file",accept:e,class:"motes-offscreen",tabindex:-1,"aria-label":i});return r.addEventListener("change",()=>{let s=r.files?.[0];s&&Ig(s,t,n).catch(t.messages.fail),r.value=""}),Ee("span",{},Yn(i,()=>r.click()),r)}var Oc=40,Sr=72,qS=4,YS=4,ZS=`
in vec3 tint;
out vec3 vTint;
out vec3 vPosition;
void main() {
  vTint = tint;
  vPosition = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`,KS=`
in vec3 vTint;
in vec3 vPosition;
out vec4 color;
void main() {
  vec3 normal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
  float facing = abs(dot(normal, normalize(cameraPosition - vPosition)));
  color = vec4(vTint * (0.35 + 0.65 * facing), 1.0);
}`,Lg=(i,e,t)=>[-i,t,e],Bc=class{scene=new Cn;camera=new Kt(30,1,.1,50);wo;positions=new Float32Array(3*(Oc+1)*Sr);tints=new Float32Array(this.positions.length);geometry=new Nt;arrow=new Vo(new W(0,-1,0),new W,1,Fg(14716960),.14,.08);lines=new qi({color:Fg(8947848)});fine=Ng(1);coarse=Ng(qS);target=Dg(1);drawn="";version=0;visible=!0;reach=1;constructor(){let e=[];for(let n=0;n<=Oc;n+=1){let r=Math.min(n/Oc,.9999)*Math.PI/2;for(let s=0;s<Sr;s+=1){let o=2*Math.PI*s/Sr;e.push(Math.sin(r)*Math.cos(o),Math.sin(r)*Math.sin(o),Math.cos(r))}}this.wo=Float32Array.from(e),this.geometry.setAttribute("position",new ht(this.positions,3)),this.geometry.setAttribute("tint",new ht(this.tints,3));let t=new St(this.geometry,new Ft({glslVersion:nn,vertexShader:ZS,fragmentShader:KS,side:Nn}));t.frustumCulled=!1,this.scene.add(t,this.ground(),this.arrow)}update(e,t,n,r){if(this.visible=e.lobe,!e.lobe)return;let s=en(e.incidence),o=[Math.sin(s),0,Math.cos(s)],a=this.wo.length/3,l=new Float32Array(3*a);for(let m=0;m<a;m+=1)l.set(o,3*m);let c=r.evaluate(t,n,l,this.wo),h=t.shader.channels,u=new Float32Array(3*a),f=new Float32Array(a);for(let m=0;m<a;m+=1){let g=0;for(let A=0;A<h;A+=1){let M=c[m*h+A];g+=M/h;for(let w=0;w<3;w+=1)u[3*m+w]+=M*t.toSrgb[A][w]}f[m]=ur(g*(e.radius==="f cos"?this.wo[3*m+2]:1),e.scale)}let p=0;for(let m of f)m>p&&(p=m);this.reach=p||1;let v=new $e;for(let m=0;m<a;m+=1){let g=Un(f[m]/this.reach,0,1);this.positions.set(Lg(this.wo[3*m]*g,this.wo[3*m+1]*g,this.wo[3*m+2]*g),3*m);let A=Math.max(u[3*m],u[3*m+1],u[3*m+2],1e-9);v.setRGB(Math.max(u[3*m],0)/A,Math.max(u[3*m+1],0)/A,Math.max(u[3*m+2],0)/A),this.tints.set([.25+.65*v.r**.45,.25+.65*v.g**.45,.25+.65*v.b**.45],3*m)}this.geometry.getAttribute("position").needsUpdate=!0,this.geometry.getAttribute("tint").needsUpdate=!0;let y=new W(...Lg(o[0],o[1],o[2]));this.arrow.position.copy(y.clone().multiplyScalar(1.12)),this.arrow.setDirection(y.clone().negate()),this.arrow.setLength(.9,.13,.08),this.version+=1}draw(e,t,n,r){let s=t.position.clone().normalize();s.y=Math.max(s.y,.16),this.camera.position.copy(s.normalize().multiplyScalar(4.6)).add(new W(0,.38,0));let o=JSON.stringify([this.camera.position,n,r,this.version]);return o===this.drawn?this.target.texture:(this.camera.lookAt(0,.38,0),this.geometry.setIndex(r?this.coarse:this.fine),this.target.setSize(n,n),e.setRenderTarget(this.target),e.clear(),e.render(this.scene,this.camera),this.drawn=o,this.target.texture)}revive(){this.target=Dg(1),this.drawn=""}ground(){let e=new kn;for(let t of[.5,1]){let n=Array.from({length:64},(r,s)=>new W(Math.cos(s*Math.PI/32)*t,0,Math.sin(s*Math.PI/32)*t));e.add(new zr(new Nt().setFromPoints(n),this.lines))}return e.add(new Mi(new Nt().setFromPoints([new W(-1,0,0),new W(1,0,0)]),this.lines)),e}};function Ng(i){let e=[];for(let t=0;t<Oc;t+=i)for(let n=0;n<Sr;n+=i){let[r,s]=[t*Sr+n,t*Sr+(n+i)%Sr],o=i*Sr;e.push(r,r+o,s,s,r+o,s+o)}return new ht(Uint16Array.from(e),1)}var Dg=i=>new tn(i,i,{samples:YS,minFilter:Mt,magFilter:Mt}),Fg=i=>new $e().setHex(i,Lt);var kc=class{constructor(e){this.shipped=e;for(let t of e.shapes)this.geometries.set(t.name,null)}shipped;geometries=new Map;own=new Map;get names(){return[...this.geometries.keys()]}get(e,t){let n=this.own.get(e);n&&n.up!==t&&(this.geometries.get(e)?.dispose(),this.geometries.set(e,Ef(n.triangles,this.shipped.dust_by_inclination,t)),n.up=t);let r=this.geometries.get(e);if(r)return r;let s=this.shipped.shapes.find(a=>a.name===e)??this.shipped.shapes[0],o=this.geometries.get(s.name)??cg(s);return this.geometries.set(s.name,o),o}isOwn(e){return this.own.has(e)}async add(e,t,n){let r=await bg(e,t),s=Ef(r,this.shipped.dust_by_inclination,n);return this.geometries.get(e)?.dispose(),this.geometries.set(e,s),this.own.set(e,{triangles:r,up:n}),{triangles:s.getIndex().count/3,tau:Rf(r)}}dispose(){for(let e of this.geometries.values())e?.dispose()}};var JS=4,zc=class{element;polite=Ee("div",{role:"status","aria-live":"polite"});urgent=Ee("div",{role:"alert"});constructor(){this.element=Ee("div",{class:"motes-messages"},this.urgent,this.polite)}say(e){this.put(this.polite,"said",e,"")}fail=e=>{let[t,n]=e instanceof oe?[e.message,e.hint]:[`The viewer failed in a way it should not: ${e instanceof Error?e.message:String(e)}`,"Load the page again and report this"];this.put(this.urgent,"failed",t,n)};put(e,t,n,r){let s=Ee("div",{class:`motes-message ${t}`},Ee("p",{},`${n.replace(/\.$/,"")}.`,r?Ee("span",{},` ${r.replace(/\.$/,"")}.`):null),Ee("button",{type:"button","aria-label":"Dismiss",onclick:()=>s.remove()},"×"));for(let o of Array.from(e.children))o.querySelector("p")?.textContent===s.querySelector("p").textContent&&o.remove();for(e.prepend(s);e.children.length>JS;)e.lastElementChild.remove()}};var Ug=.4;function kg(i,e){let t=new Map,n=!1,r=0;i.addEventListener("contextmenu",a=>a.preventDefault()),i.addEventListener("pointerdown",a=>{i.setPointerCapture(a.pointerId),t.set(a.pointerId,{x:a.clientX,y:a.clientY}),n=a.shiftKey||a.button===2,r=Bg(t)}),i.addEventListener("pointermove",a=>{let l=t.get(a.pointerId);if(!l)return;let[c,h]=[a.clientX-l.x,a.clientY-l.y];if(t.set(a.pointerId,{x:a.clientX,y:a.clientY}),t.size>1){let u=Bg(t);r>0&&u>0&&o(r/u),r=u}else s(c*Ug,h*Ug,n)});for(let a of["pointerup","pointercancel"])i.addEventListener(a,l=>t.delete(l.pointerId));i.addEventListener("wheel",a=>{a.preventDefault(),o(Math.exp(Un(a.deltaY,-200,200)*.0015))},{passive:!1}),i.addEventListener("keydown",a=>{let c={ArrowLeft:[-6,0],ArrowRight:[6,0],ArrowUp:[0,-6],ArrowDown:[0,6]}[a.key];if(c)s(c[0],c[1],a.shiftKey);else if(a.key==="+"||a.key==="=")o(.9);else if(a.key==="-")o(1/.9);else return;a.preventDefault()});function s(a,l,c){let{state:h}=e;c?e.change({lampAzimuth:Og(h.lampAzimuth+a),lampElevation:Un(h.lampElevation-l,$t.lampElevation.low,$t.lampElevation.high)}):e.change({azimuth:Og(h.azimuth-a),elevation:Un(h.elevation+l,$t.elevation.low,$t.elevation.high)})}function o(a){e.change({distance:Un(e.state.distance*a,$t.distance.low,$t.distance.high)})}}var Og=i=>((i+180)%360+360)%360-180;function Bg(i){let[e,t]=[...i.values()];return e&&t?Math.hypot(e.x-t.x,e.y-t.y):0}var Hc=class{constructor(e){this.payload=e;this.own=[ch(e.materials[0]),e.materials[1]?ch(e.materials[1]):null],this.materials=[...this.own]}payload;own;materials;library=null;get all(){return this.materials}get two(){return this.materials[1]!==null}get cameWithTwo(){return this.own[1]!==null}get firstHours(){return this.materials.map(e=>e?.time?.interval[0]).find(e=>e!==void 0)}at(e){return this.materials[e]??null}active(e){return this.materials[e.active]}shown(e){return e.compare==="one"?[this.active(e)]:[this.materials[0],this.materials[1]]}held(e,t){let n=this.at(t);return n?hd(n,e.values[t]):{}}values(e,t){let n=this.at(t);return n?ud(n,n.time?e.hours:null,this.held(e,t)):{}}shownValues(e){return e.compare==="one"?[this.values(e,e.active)]:[this.values(e,0),this.values(e,1)]}interval(e){let n=(e.compare==="one"?[this.at(e.active)]:this.materials).flatMap(r=>r?.time?[r.time.interval]:[]);return n.length?[Math.min(...n.map(r=>r[0])),Math.max(...n.map(r=>r[1]))]:null}read(e){return this.library??=Jf(this.payload.library),ad(e,this.library)}follow(e,t){this.materials=[0,1].map(n=>{let r=e.dropped[n];if(!r)return this.own[n];let s=this.materials[n];if(s?.dropped&&JSON.stringify(s.json)===JSON.stringify({...r,name:s.json.name,channels:s.json.channels}))return s;try{return this.read(r).material}catch(o){return t(o),this.own[n]}})}};var jS=4,Gc=class{constructor(e,t){this.hold=e;this.fail=t}hold;fail;element=Ee("div",{class:"motes-parameters"});rows=[];material=null;current={};show(e,t,n){this.current=t,e!==this.material&&this.make(e);for(let{slot:r,sliders:s,state:o}of this.rows){let a=t[r.name],l=r.name in n;for(let{slider:h,channel:u}of s)h.show(u===null?zg(a)/(zg(r.value)||1):a[u],l);let c=e.time?.trends[r.name];o.classList.toggle("own",l),qn(o,l?` · set by hand${c?", no longer follows time":""}`:c?` · follows time: ${c.kind.replaceAll("_"," ")}`:"")}}make(e){this.material=e,this.rows=e.slots.map(t=>this.row(e,t)),this.element.replaceChildren(...this.rows.map(({slot:t,sliders:n,state:r})=>Ee("div",{class:"motes-parameter",role:"group","aria-label":`${t.name}: ${t.declared.meaning}`},...n.map(({slider:s})=>s.element),Ee("p",{class:"motes-meaning"},`${t.declared.meaning}, ${ew(t)}`,r))))}row(e,t){let{declared:n}=t,r=Ee("span",{class:"motes-held"}),s=t.value.length,o={symbol:n.symbol,unit:n.unit,hint:n.meaning,reset:()=>this.hold(t.name,null)};if(s>jS){let u=f=>{let p=t.value.map(v=>v*f);for(let v of p)Sa(t,v);this.hold(t.name,p)};return{slot:t,state:r,sliders:[{slider:new Li({...o,label:`${t.name}, factor for all ${s} channels`,low:0,high:2,set:u},this.fail),channel:null}]}}let[a,l]=QS(t),c=_i(e.channels,e.wavelengths),h=t.value.map((u,f)=>{let p=s>1?` ${e.channels[f]??f+1}`:"",v=m=>{Sa(t,m),this.hold(t.name,this.current[t.name].map((g,A)=>A===f?m:g))},y=s>1?c.find(m=>m.channel===f)?.tint:void 0;return{slider:new Li({...o,label:`${t.name}${p}`,shown:`${t.name===n.symbol?"":t.name}${p}`,low:a,high:l,set:v,...y?{tint:y}:{}},this.fail),channel:f}});return{slot:t,sliders:h,state:r}}};function QS(i){let{low:e,high:t,open:n,typical:r}=i.declared,s=n&&t!==null?(t-e)*.001:0,o=Math.max(Math.min(r[0],...i.value),e+s),a=Math.min(Math.max(r[1],...i.value.map(l=>l*1.25)),(t??1/0)-s);return[o,a]}function ew(i){let{low:e,high:t,open:n,unit:r}=i.declared,s=t===null?"∞":String(Number(t.toPrecision(4)));return`${n?"(":"["}${e}, ${s}${n||t===null?")":"]"}${r?` ${r}`:""}`}var zg=i=>i.reduce((e,t)=>e+t,0)/i.length;var Hg=`
uniform sampler2D before;
uniform sampler2D now;
uniform float share;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = mix(texelFetch(before, at, 0), texelFetch(now, at, 0), share);
}`,Gg=`
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
}`,Vg=`
uniform sampler2D corner;
out vec4 color;
void main() { color = texelFetch(corner, ivec2(gl_FragCoord.xy), 0); }`;function $n(i,e,t){return new tn(i,e,{type:yt,format:xt,minFilter:Mt,magFilter:Mt,depthBuffer:t})}function Vc(i,e,t){return new Ft({glslVersion:e,vertexShader:Ws,fragmentShader:i,uniforms:t,depthTest:!1,depthWrite:!1})}function Df(i,e){let[t,n,r]=[0,1,i];for(;r>0;)n/=e,t+=n*(r%e),r=Math.floor(r/e);return i===0?0:t-.5}var tw=`
in float dust;
out vec3 vPosition;
out vec3 vNormal;
out float vDust;
void main() {
  vPosition = position;
  vNormal = normal;
  vDust = dust;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`,nw=`
in vec3 vPosition;
in vec3 vNormal;
in float vDust;
out vec4 seen;
void main() {
  vec3 normal = gl_FrontFacing ? vNormal : -vNormal;
  normal /= abs(normal.x) + abs(normal.y) + abs(normal.z);
  vec2 side = vec2(normal.x < 0.0 ? -1.0 : 1.0, normal.y < 0.0 ? -1.0 : 1.0);
  seen = vec4(normal.z < 0.0 ? (1.0 - abs(normal.yx)) * side : normal.xy, distance(cameraPosition, vPosition), vDust);
}`,Wg=`
uniform sampler2D surface;
uniform vec3 eye;
in vec3 vRay;
bool seen(out vec3 position, out vec3 normal, out float dust) {
  vec4 found = texelFetch(surface, ivec2(gl_FragCoord.xy), 0);
  position = eye + found.z * normalize(vRay);
  normal = vec3(found.xy, 1.0 - abs(found.x) - abs(found.y));
  float folded = max(-normal.z, 0.0);
  normal.xy -= vec2(normal.x < 0.0 ? -folded : folded, normal.y < 0.0 ? -folded : folded);
  normal = normalize(normal);
  dust = found.w;
  return found.z > 0.0;
}`,$g=`
uniform vec3 ahead;
uniform vec3 across;
uniform vec3 above;
out vec3 vRay;
void main() {
  vRay = ahead + position.x * across + position.y * above;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`,Xg=()=>({surface:{value:null},eye:{value:new W},ahead:{value:new W},across:{value:new W},above:{value:new W}}),Wc=class{mesh=new St(void 0,new Ft({glslVersion:nn,vertexShader:tw,fragmentShader:nw,side:2}));scene=new Cn;target=$n(1,1,!0);constructor(){this.mesh.frustumCulled=!1,this.scene.add(this.mesh)}setSize(e,t){this.target.setSize(e,t)}draw(e,t,n,r){for(let{view:s,shown:o}of r)this.target.viewport.set(s[0],0,s[1],n),this.target.scissor.set(o[0],0,o[1],n),this.target.scissorTest=!0,e.setRenderTarget(this.target),e.clear(),e.render(this.scene,t)}bounds(e,t,{view:n,shown:r}){let{geometry:s}=this.mesh;s.boundingSphere||s.computeBoundingSphere();let{center:o,radius:a}=s.boundingSphere,l=o.clone().applyMatrix4(e.matrixWorldInverse),{elements:c}=e.projectionMatrix,h=(y,m,g)=>{let A=l.getComponent(y),M=Math.hypot(A,l.z);if(!(M>a&&l.z<0))return[m,m+g];let[w,T]=[Math.atan2(A,-l.z),Math.asin(a/M)],E=[w-T,w+T].map(P=>Math.abs(P)<Math.PI/2?Math.tan(P):1/0*Math.sign(P)),[x,b]=E.map(P=>m+g*(P*c[5*y]-c[8+y]+1)/2);return[Math.floor(x),Math.ceil(b)]},[u,f]=h(0,...n),[p,v]=h(1,0,t);return[Math.max(u,r[0]),Math.min(f,r[0]+r[1]),Math.max(p,0),Math.min(v,t)]}tell({uniforms:e},t){let{elements:n}=t.projectionMatrix;e.surface.value=this.target.texture,e.eye.value.copy(t.position);let r=new Ke().setFromMatrix4(t.matrixWorld);e.ahead.value.set(n[8]/n[0],n[9]/n[5],-1).applyMatrix3(r),e.across.value.set(1/n[0],0,0).applyMatrix3(r),e.above.value.set(0,1/n[5],0).applyMatrix3(r)}revive(){this.target=$n(this.target.width,this.target.height,!0)}dispose(){this.target.dispose(),this.mesh.material.dispose()}};function Jr(i,e){return Object.fromEntries(i.shader.uniforms.map(t=>{let n=e[t.slot];return[t.name,{value:t.size===1?n[0]:[...n]}]}))}function $c(i,e){return i.shader.uniforms.map(t=>e&&t.slot===i.tau?`${t.name} * ${e}`:t.name)}function aa(i,e,t,n){return`${i.shader.name}_${e}(${["wi","wo",...$c(i,t),...n?[n]:[]].join(", ")})`}var iw=i=>i.shader.channels!==1&&i.shader.channels!==3;function rw(i){let{channels:e,stages:t}=i.shader,n=t?"light":"with",r=i.toSrgb.map(o=>`vec3(${o.map(a=>a.toPrecision(9)).map(a=>/[.e]/.test(a)?a:`${a}.0`).join(", ")})`),s="vec3 reflected(vec3 wi, vec3 wo, float share) {";return e===1?`${s}
  return ${aa(i,n,"share","")};
}`:e===3?`${s}
  vec3 f = ${aa(i,n,"share","")};
  return f.x * ${r[0]} + f.y * ${r[1]} + f.z * ${r[2]};
}`:[`const vec3 TO_SRGB[${e}] = vec3[${e}](${r.join(", ")});`,s,`  float f[${e}];`,`  ${aa(i,n,"share","f")};`,"  vec3 sum = vec3(0.0);",`  for (int k = 0; k < ${e}; ++k) sum += f[k] * TO_SRGB[k];`,"  return sum;","}"].join(`
`)}function qg(i,e){return`
${i.shader.source}
${e}
${rw(i)}
uniform vec3 lampPosition;
uniform float lampStrength;
uniform sampler2D skyDirections;
uniform int skyFirst;
uniform int skyCount;
uniform float skyStrength;
uniform float painted;
${Wg}
out vec4 color;
const float PI = 3.14159265358979;
const float GRAZING = 0.01;
vec3 lit(vec3 place, vec3 normal, float dust) {
  vec3 view = -normalize(vRay);
  vec3 side = normalize(cross(abs(normal.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), normal));
  mat3 frame = transpose(mat3(side, cross(normal, side), normal));
  vec3 wo = frame * view;
  // Interpolated normals may turn away from the eye at an outline: such a point is seen at grazing.
  wo = normalize(vec3(wo.xy, max(wo.z, GRAZING)));
  float share = mix(1.0, dust, painted);
  begin(wo, share);
  vec3 toLamp = lampPosition - place;
  float squared = dot(toLamp, toLamp);
  // lampStrength: the radiance of a white diffuser at the middle that faces the lamp.
  vec3 weight = vec3(PI * lampStrength * dot(lampPosition, lampPosition) / squared);
  vec3 wi = frame * (toLamp * inversesqrt(squared));
  vec3 sum = vec3(0.0);
  // The lamp goes first through the same loop: where a BRDF is written twice, a processor that draws compiles it twice.
  // What lies below the horizon is passed over before: pixels side by side, which a processor computes together, seldom wait for each other then.
  int next = skyFirst;
  int end = skyFirst + skyCount;
  bool more = true;
  while (more) {
    if (wi.z > 0.0) sum += reflected(wi, wo, share) * (wi.z * weight);
    wi.z = 0.0;
    while (wi.z <= 0.0 && next < end) {
      wi = frame * texelFetch(skyDirections, ivec2((2 * next) & 255, (2 * next) >> 8), 0).xyz;
      next += 1;
    }
    more = wi.z > 0.0;
    int at = max(2 * next - 1, 0);
    weight = texelFetch(skyDirections, ivec2(at & 255, at >> 8), 0).xyz * (skyStrength / float(max(skyCount, 1)));
  }
  return sum;
}
void main() {
  vec3 place, normal;
  float dust;
  // A processor that draws computes what is discarded, but no branch that no pixel takes.
  if (seen(place, normal, dust)) color = vec4(lit(place, normal, dust), 1.0);
  else discard;
}`}var Ws=`
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;function Yg(i){let{channels:e}=i.shader,t=iw(i)?`float f[${e}];
  ${aa(i,"with","","f")};
  for (int k = 0; k < 4; ++k) if (firstChannel + k < ${e}) found[k] = f[firstChannel + k];`:`found.xyz = ${aa(i,"with","","")};`;return`
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
}`}var $s=256,Xc=class{constructor(e){this.renderer=e;this.mesh.frustumCulled=!1,this.scene.add(this.mesh)}renderer;scene=new Cn;camera=new Vn;mesh=new St(new li(2,2));programs=new Map;target=null;evaluate(e,t,n,r){let s=n.length/3,o=e.shader.channels,a=new Float32Array(s*o);if(!s)return a;let l=Math.ceil(s/$s),[c,h]=[this.texture(n,l),this.texture(r,l)];(!this.target||this.target.height!==l)&&(this.target?.dispose(),this.target=new tn($s,l,{type:yt,format:xt,minFilter:Mt,magFilter:Mt,depthBuffer:!1}));let u=this.program(e);Object.assign(u.uniforms,Jr(e,t)),this.mesh.material=u;let f=new Float32Array(4*$s*l),p=o<=3?3:4;for(let v=0;v<o;v+=p){u.uniforms.toLight={value:c},u.uniforms.toViewer={value:h},u.uniforms.firstChannel={value:v},u.uniformsNeedUpdate=!0,this.renderer.setRenderTarget(this.target),this.renderer.render(this.scene,this.camera),this.renderer.readRenderTargetPixels(this.target,0,0,$s,l,f);let y=Math.min(p,o-v);for(let m=0;m<s;m+=1)for(let g=0;g<y;g+=1)a[m*o+v+g]=f[4*m+g]}return this.renderer.setRenderTarget(null),c.dispose(),h.dispose(),a}keep(e){for(let[t,n]of this.programs)e.includes(t)||(n.dispose(),this.programs.delete(t))}revive(){this.target=null}program(e){let t=this.programs.get(e);return t||(t=new Ft({glslVersion:nn,vertexShader:Ws,fragmentShader:Yg(e),depthTest:!1,depthWrite:!1}),this.programs.set(e,t)),t}texture(e,t){let n=new Float32Array(4*$s*t);for(let s=0;s<e.length/3;s+=1)for(let o=0;o<3;o+=1)n[4*s+o]=e[3*s+o];let r=new gn(n,$s,t,xt,yt);return r.needsUpdate=!0,r}};var Zg=`
out vec3 vDirection;
void main() {
  vDirection = position;
  gl_Position = projectionMatrix * viewMatrix * vec4(position + cameraPosition, 1.0);
}`,Kg=`
uniform sampler2D sky;
uniform float strength;
in vec3 vDirection;
out vec4 color;
const ivec2 SIZE = ivec2(${pt}, ${Et});
vec3 cell(ivec2 at) { return texelFetch(sky, ivec2((at.x + SIZE.x) % SIZE.x, clamp(at.y, 0, SIZE.y - 1)), 0).xyz; }
void main() {
  vec3 w = normalize(vDirection);
  vec2 place = vec2(atan(w.x, w.z) / 6.283185307, acos(clamp(w.y, -1.0, 1.0)) / 3.141592654) * vec2(SIZE) - 0.5;
  ivec2 at = ivec2(floor(place));
  vec2 part = place - vec2(at);
  vec3 above = mix(cell(at), cell(at + ivec2(1, 0)), part.x);
  vec3 below = mix(cell(at + ivec2(0, 1)), cell(at + ivec2(1, 1)), part.x);
  color = vec4(mix(above, below, part.y) * strength, 1.0);
}`;function Jg(i){let e=new Float32Array(i.length/3*4);for(let n=0;n<i.length/3;n+=1)e.set(i.subarray(3*n,3*n+3),4*n);let t=new gn(e,pt,Et,xt,yt);return t.needsUpdate=!0,t}var sr=96,Dt=65,sw=1.1,qc=6,Ff=16,Uf=24,ow=.35,aw=`
in float hidden;
out float vHidden;
void main() {
  vHidden = hidden;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`,lw=`
uniform float strength;
in float vHidden;
out vec4 color;
void main() { color = vec4(0.0, 0.0, 0.0, clamp(vHidden * strength, 0.0, 1.0)); }`;function Qg(){return new Ft({glslVersion:nn,vertexShader:aw,fragmentShader:lw,side:Qn,depthWrite:!1,uniforms:{strength:{value:1}}})}function e0(i){let e=i.getAttribute("position").array,t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let M=0;M<e.length;M+=1)t[M%3]=Math.min(t[M%3],e[M]),n[M%3]=Math.max(n[M%3],e[M]);let[r,s]=[(t[0]+n[0])/2,(t[2]+n[2])/2],o=Math.max(n[0]-t[0],n[2]-t[2],.2)/2,a=2*o/sr,[l,c]=[new Float32Array(sr*sr).fill(1/0),new Float32Array(sr*sr).fill(-1/0)],h=(M,w)=>{let[T,E]=[Math.floor((M-r+o)/a),Math.floor((w-s+o)/a)];return E<0||T<0||E>=sr||T>=sr?-1:E*sr+T};cw(e,i.getIndex().array,a,(M,w,T)=>{let E=h(M,T);E<0||(l[E]=Math.min(l[E],w-t[1]),c[E]=Math.max(c[E],w-t[1]))});let u=n[1]-t[1],f=o*(1+sw),p=new Float32Array(3*Dt*Dt),v=new Float32Array(Dt*Dt);for(let M=0;M<Dt*Dt;M+=1){let[w,T]=[2*(M%Dt)/(Dt-1)-1,2*Math.floor(M/Dt)/(Dt-1)-1],[E,x]=[r+w*f,s+T*f];p.set([E,t[1]-.002,x],3*M),Math.hypot(w,T)<1&&(v[M]=A(E,x))}let y=v.map((M,w)=>jg(v,w));for(let M=0;M<v.length;M+=1){let w=Math.hypot(2*(M%Dt)/(Dt-1)-1,2*Math.floor(M/Dt)/(Dt-1)-1);v[M]=jg(y,M)*Math.min(Math.max((1-w)/ow,0),1)}let m=[];for(let M=0;M+1<Dt;M+=1)for(let w=0;w+1<Dt;w+=1){let T=M*Dt+w;m.push(T,T+Dt,T+1,T+1,T+Dt,T+Dt+1)}let g=new Nt;return g.setAttribute("position",new ht(p,3)),g.setAttribute("hidden",new ht(v,1)),g.setIndex(m),g;function A(M,w){let T=0;for(let E=0;E<qc;E+=1){let x=Math.sqrt((E+.5)/qc),b=Math.sqrt(1-x*x)/x,P=Math.min(u/b,o+Math.hypot(M-r,w-s))||a;for(let I=0;I<Ff;I+=1){let F=2*Math.PI*(I+E/qc)/Ff;for(let B=0;B<Uf;B+=1){let[z,D]=[P*B/Uf,P*(B+1)/Uf],$=h(M+Math.sin(F)*(z+D)/2,w+Math.cos(F)*(z+D)/2);if($>=0&&l[$]<=D*b&&c[$]>=z*b){T+=1;break}}}}return T/(qc*Ff)}}function jg(i,e){let[t,n]=[0,0];for(let r=Math.max(Math.floor(e/Dt)-1,0);r<=Math.min(Math.floor(e/Dt)+1,Dt-1);r+=1)for(let s=Math.max(e%Dt-1,0);s<=Math.min(e%Dt+1,Dt-1);s+=1)t+=i[r*Dt+s],n+=1;return t/n}function cw(i,e,t,n){for(let s=0;s<e.length;s+=3){let[o,a,l]=[3*e[s],3*e[s+1],3*e[s+2]],c=Math.max(r(o,a),r(a,l),r(l,o)),h=Math.min(Math.max(Math.ceil(c/t),1),sr);for(let u=0;u<=h;u+=1)for(let f=0;f<=h-u;f+=1){let[p,v]=[u/h,f/h],y=m=>i[o+m]+p*(i[a+m]-i[o+m])+v*(i[l+m]-i[o+m]);n(y(0),y(1),y(2))}}function r(s,o){return Math.hypot(i[o]-i[s],i[o+2]-i[s+2])}}function t0(i){return i.kept.flatMap(({name:e,type:t})=>t==="bool"?[{read:`(${e} ? 1.0 : 0.0)`,write:r=>`${e} = ${r} > 0.5;`}]:(t==="vec3"?[".x",".y",".z"]:[""]).map(r=>({read:e+r,write:s=>`${e}${r} = ${s};`})))}function n0(i){let{shader:e}=i;if(!e.stages)return"void begin(vec3 wo, float share) {}";let t=$c(i,"share"),n=`${e.name}_view(${["wo",...t].join(", ")});`;if(!e.kept.length)return`void begin(vec3 wo, float share) {
  ${e.name}_parameters(${t.join(", ")});
  ${n}
}`;let r=t0(e),s=Array.from({length:Math.ceil(r.length/4)},(o,a)=>[`  row = mix(texelFetch(kept, ivec2(column, ${a}), 0), texelFetch(kept, ivec2(column + 1, ${a}), 0), part);`,...r.slice(4*a,4*a+4).map(({write:l},c)=>`  ${l(`row.${"xyzw"[c]}`)}`)]).flat();return["uniform sampler2D kept;","void begin(vec3 wo, float share) {",`  float place = share > 0.0 ? clamp(pow(share, 1.0 / 3.0) * ${256}.0, 1.0, ${256}.0) : 0.0;`,`  int column = min(int(place), ${255});`,"  float part = place - float(column);","  vec4 row;",...s,`  ${n}`,"}"].join(`
`)}function hw(i,e,t){let n=new Float32Array(i),r=new Float32Array(4*257*t);for(let o=0;o<257;o+=1)for(let a=0;a<e;a+=1)r[4*(Math.floor(a/4)*257+o)+a%4]=n[o*e+a];let s=new gn(r,257,t,xt,yt);return s.needsUpdate=!0,s}var Yc=class{constructor(e){this.material=e;let{shader:t}=e,n=t0(t),r=Math.ceil(n.length/4),s=Array.from({length:r},(o,a)=>`    case ${a}: value = vec4(${Array.from({length:4},(l,c)=>n[4*a+c]?.read??"0.0").join(", ")}); break;`);this.target=$n(257,r,!1),this.program=new Ft({glslVersion:nn,vertexShader:Ws,fragmentShader:`${t.source}
out vec4 value;
void main() {
  float share = floor(gl_FragCoord.x) / ${256}.0;
  share *= share * share;
  ${t.name}_parameters(${$c(e,"share").join(", ")});
  switch (int(gl_FragCoord.y)) {
${s.join(`
`)}
  }
}`,depthTest:!1,depthWrite:!1}),this.quad=new St(new li(2,2),this.program),this.quad.frustumCulled=!1,this.scene.add(this.quad),t.table&&(this.given=hw(gi(t.table.data),n.length,r))}material;target;program;scene=new Cn;camera=new Vn;quad;drawn="";given=null;texture(e,t){if(this.given&&this.isGiven(t))return this.given;let n=JSON.stringify(t);return n!==this.drawn&&(Object.assign(this.program.uniforms,Jr(this.material,t)),this.program.uniformsNeedUpdate=!0,e.setRenderTarget(this.target),e.render(this.scene,this.camera),this.drawn=n),this.target.texture}ready(e,t){this.given&&(Object.assign(this.program.uniforms,Jr(this.material,t)),e.setRenderTarget(this.target),e.render(this.scene,this.camera))}isGiven(e){let t=this.material.shader.table?.values??{};return Object.entries(t).every(([n,r])=>r.every((s,o)=>Math.abs(s-(e[n]?.[o]??NaN))<=1e-6*Math.abs(s)))}revive(){this.target=$n(257,this.target.height,!1),this.drawn=""}dispose(){this.target.dispose(),this.given?.dispose(),this.program.dispose(),this.quad.geometry.dispose()}};function Of(i,e){let[t,n]=[en(i),en(e)];return new W(Math.sin(t)*Math.cos(n),Math.sin(n),Math.cos(t)*Math.cos(n))}function i0(i){return new Ft({glslVersion:nn,vertexShader:$g,fragmentShader:qg(i,n0(i)),uniforms:{...Xg(),lampPosition:{value:new W},lampStrength:{value:1},skyDirections:{value:null},skyFirst:{value:0},skyCount:{value:0},skyStrength:{value:1},painted:{value:0},kept:{value:null}},depthTest:!1,depthWrite:!1})}var r0=[60,160],Zc=class{batch=4;coarseness=3;budget=0;times=[];turning=!1;follow(e,t,n){if(this.budget||=8*n,this.times.length&&(t!==this.turning||e-this.times.at(-1)>3e3)&&(this.times=[]),this.turning=t,this.times.push(e),this.times.length<(t?6:4))return;let r=(e-this.times[0])/(this.times.length-1);this.times=[],t?r>45?this.batch>2?this.batch/=2:this.coarseness=Math.min(Math.ceil(this.coarseness*Math.min(Math.sqrt(r/45),2)),8):r<45/2&&(this.coarseness>1?this.coarseness-=1:this.batch<64&&(this.batch*=2)):r>r0[1]?this.budget=Math.max(this.budget/2,8):r<r0[0]&&(this.budget=Math.min(this.budget*2,64*n))}};var dw={neutral:Fs,agx:Xo,clip:$o},pw=6,s0=16,mw=.34,gw=120,Kc=class{constructor(e){this.canvas=e;let t={antialias:!1,alpha:!0,premultipliedAlpha:!0,preserveDrawingBuffer:!0,powerPreference:"high-performance"},n=e.getContext("webgl2",t);if(!n)throw new oe("This browser has no WebGL 2, which the viewer draws with","Switch on hardware acceleration or try another browser; the pictures below stand in for it");if(!n.getExtension("EXT_color_buffer_float"))throw new oe("This browser cannot draw into floating-point textures, which the viewer needs","Try another browser; the pictures below stand in for it");this.renderer=new Tc({canvas:e,context:n,antialias:!1,alpha:!0,premultipliedAlpha:!0,preserveDrawingBuffer:!0,powerPreference:"high-performance"}),this.renderer.autoClear=!1,this.renderer.setClearColor(0,0),this.quad.frustumCulled=!1,this.flat.add(this.quad),this.backdrop=new St(new Do(40,32,16),new Ft({glslVersion:nn,vertexShader:Zg,fragmentShader:Kg,side:un,depthWrite:!1,uniforms:{sky:{value:null},strength:{value:1}}})),this.ground.frustumCulled=!1,Object.assign(this.corner,{transparent:!0,premultipliedAlpha:!0}),this.scene.add(this.backdrop,this.ground),this.sample=$n(1,1,!1),this.sums=[$n(1,1,!1),$n(1,1,!1)]}canvas;renderer;camera=new Kt(30,1,.05,100);scene=new Cn;surface=new Wc;mesh=this.surface.mesh;backdrop;ground=new St(void 0,Qg());groundDue=!0;shownOnce=!1;up=0;own=null;flat=new Cn;flatCamera=new Vn;quad=new St(new li(2,2));averaging=Vc(Hg,nn,{before:{value:null},now:{value:null},share:{value:1}});showing=Vc(Gg,null,{average:{value:null}});corner=Vc(Vg,nn,{corner:{value:null}});shown=[];sample;sums;frame=0;drawn=0;environment="";sky=null;moved=!0;dark=!1;pace=new Zc;movedAt=0;row=0;stale=!0;lobe=null;setMaterials(e){let t=this.shown;this.shown=e.map(n=>t.find(r=>r.material===n)??{material:n,program:i0(n),kept:n.shader.kept.length?new Yc(n):null});for(let n of t)this.shown.includes(n)||o0(n);this.restart()}setGeometry(e){this.mesh.geometry=e,this.groundDue=!0,this.restart()}resize(e,t,n){let[r,s]=[Math.max(Math.round(e*n),1),Math.max(Math.round(t*n),1)];if(!(this.sample.width===r&&this.sample.height===s)){this.sample.setSize(r,s),this.surface.setSize(r,s);for(let o of this.sums)o.setSize(r,s);this.restart()}}setOwn(e){this.own=e,this.environment="",this.restart()}restart(){this.frame=0,this.drawn=0,this.row=0,this.moved=!0}get complete(){return this.frame>=s0&&(this.dark||this.drawn>=rr)}get progress(){return Math.min(this.frame/s0,this.dark?1:this.drawn/rr,1)}draw(e,t){e.environment!==this.environment&&this.setEnvironment(e.environment),this.dark=e.environment==="none"||e.sky===0,this.groundDue&&this.shownOnce&&(this.ground.geometry.dispose(),this.ground.geometry=e0(this.mesh.geometry),this.groundDue=!1,this.shown.forEach(({kept:o},a)=>o?.ready(this.renderer,t[a])));let n=performance.now();if(this.moved)this.movedAt=n;else if(this.pace.coarseness>1&&this.frame===0&&this.row===0&&n-this.movedAt<gw)return;this.pace.follow(n,this.moved,this.sample.height);let r=this.moved?this.pace.coarseness:1,s=this.moved||this.complete;if(this.moved&&r>1?this.shade(e,t,...this.size(r),this.pace.batch):this.complete||(s=this.pass(e,t)),s||this.stale&&this.frame>0){let[o,a]=this.fit(r);this.show(e,r===1?this.sums[0]:this.sample,o,a),this.lobe?.visible&&this.cover(this.lobe.draw(this.renderer,this.camera,Math.round(Math.min(o,a)*mw),r>1)),this.stale=!1,this.shownOnce=!0}this.moved=!1}size(e){return[Math.ceil(this.sample.width/e),Math.ceil(this.sample.height/e)]}fit(e){let[t,n]=this.size(e);return(this.canvas.width!==t||this.canvas.height!==n)&&this.renderer.setSize(t,n,!1),[t,n]}pass(e,t){let{width:n,height:r}=this.sample,s=Math.min(this.moved?this.pace.batch:Math.min(Math.max(this.drawn,8),64),rr-this.drawn%rr),o=this.moved?r:Math.max(Math.floor(this.pace.budget/s),1),a=Math.min(this.row+o,r);return this.shade(e,t,n,r,s,this.row,a),this.row=a%r,this.row?!1:(this.drawn+=s,this.add(s/this.drawn),this.frame+=1,!0)}shade(e,t,n,r,s,o=0,a=r){let l=this.renderer,c=this.shown.map(({kept:u},f)=>u?.texture(l,t[f])??null);this.place(e,n,r);let h=this.parts(e,n);o===0&&this.surface.draw(l,this.camera,r,h),this.sample.scissorTest=!0,this.sample.scissor.set(0,o,n,a-o),l.setRenderTarget(this.sample),l.clear(),h.forEach((u,f)=>{let{view:p,shown:v}=u,{material:y,program:m}=this.shown[f];Object.assign(m.uniforms,Jr(y,t[f])),this.light(m,e,s),this.surface.tell(m,this.camera),m.uniforms.kept.value=c[f],this.sample.viewport.set(p[0],0,p[1],r),this.sample.scissor.set(v[0],o,v[1],a-o),l.setRenderTarget(this.sample),(this.backdrop.visible||this.ground.visible)&&l.render(this.scene,this.camera);let[g,A,M,w]=this.surface.bounds(this.camera,r,u),[T,E]=[Math.max(M,o),Math.min(w,a)];A<=g||E<=T||(this.sample.scissor.set(g,T,A-g,E-T),l.setRenderTarget(this.sample),this.quad.material=m,l.render(this.flat,this.flatCamera))})}radiance(){let{width:e,height:t}=this.sums[0],n=new Float32Array(4*e*t);return this.renderer.readRenderTargetPixels(this.sums[0],0,0,e,t,n),{width:e,height:t,data:n}}revive(){let{width:e,height:t}=this.sample;this.sample=$n(e,t,!1),this.sums=[$n(e,t,!1),$n(e,t,!1)],this.surface.revive(),this.lobe?.revive();for(let{kept:n}of this.shown)n?.revive();this.environment="",this.sky=null,this.backdrop.material.uniforms.sky.value=null,this.restart()}dispose(){for(let e of this.shown)o0(e);for(let e of[this.sample,...this.sums])e.dispose();this.sky?.dispose(),this.surface.dispose(),this.ground.geometry.dispose(),this.ground.material.dispose(),this.renderer.dispose()}parts(e,t){if(this.shown.length<2)return[{view:[0,t],shown:[0,t]}];if(e.compare==="side")return[[0,Math.floor(t/2)],[Math.ceil(t/2),Math.floor(t/2)]].map(([r,s])=>({view:[r,s],shown:[r,s]}));let n=Math.round(t*e.split);return[{view:[0,t],shown:[0,n]},{view:[0,t],shown:[n,t-n]}]}place(e,t,n){let r=this.shown.length>1&&e.compare==="side"?t/2/n:t/n;this.camera.aspect=r;let s=e.distance*Math.max(1,1/r);this.camera.position.copy(Of(e.azimuth,e.elevation)).multiplyScalar(s),this.camera.lookAt(0,0,0);let o=[Df(this.frame,2),Df(this.frame,3)];this.camera.setViewOffset(t,n,o[0],o[1],t,n),this.camera.updateProjectionMatrix(),this.camera.updateMatrixWorld(),this.backdrop.visible=e.backdrop&&e.environment!=="none";let[a,l]=[this.up*e.sky,e.lamp*Math.max(Math.sin(en(e.lampElevation)),0)];this.ground.visible=e.ground&&!this.groundDue&&!this.dark&&!this.backdrop.visible,this.ground.material.uniforms.strength.value=a>0?a/(a+l):0}light(e,t,n){let r=e.uniforms;r.lampPosition.value.copy(Of(t.lampAzimuth,t.lampElevation)).multiplyScalar(pw),r.lampStrength.value=t.lamp,r.skyDirections.value=this.sky,r.skyFirst.value=this.drawn%rr,r.skyCount.value=this.dark?0:n,r.skyStrength.value=t.sky,r.painted.value=t.dust?1:0,e.uniformsNeedUpdate=!0,this.backdrop.material.uniforms.strength.value=t.sky}add(e){let t=this.renderer;this.averaging.uniforms.before.value=this.sums[0].texture,this.averaging.uniforms.now.value=this.sample.texture,this.averaging.uniforms.share.value=e,this.quad.material=this.averaging,t.setRenderTarget(this.sums[1]),t.render(this.flat,this.flatCamera),this.sums=[this.sums[1],this.sums[0]]}show(e,t,n,r){let s=this.renderer;s.setRenderTarget(null),s.setScissorTest(!1),s.setViewport(0,0,n,r),s.clear(),s.toneMapping=dw[e.tone]??Fs,s.toneMappingExposure=2**e.exposure,this.showing.uniforms.average.value=t.texture,this.quad.material=this.showing,s.render(this.flat,this.flatCamera)}cover(e){let{renderer:t,corner:n}=this,{width:r,height:s}=e.image;n.uniforms.corner.value=e,this.quad.material=n,t.setRenderTarget(null),t.setViewport(0,0,r,s),t.render(this.flat,this.flatCamera)}prepare(e,t,n){this.mesh.geometry=n,this.shade(e,t,1,1,1),this.show(e,this.sample,1,1),this.renderer.getContext().flush()}setEnvironment(e){this.sky?.dispose();let t=e==="own"?this.own??Vs("studio"):Vs(e);this.up=Sg(t),this.sky=wg(t);let n=this.backdrop.material.uniforms;n.sky.value?.dispose(),n.sky.value=Jg(t),this.environment=e}};function o0({program:i,kept:e}){i.dispose(),e?.dispose()}var vw={sphere:"Sphere",teapot:"Teapot",bunny:"Bunny"},Jc=class{constructor(e,t,n,r,s,o){this.store=e;this.start=t;this.fail=n;this.scene=this.sceneSection(r,s),this.compare=this.compareSection(s,o)}store;start;fail;scene;compare;skyName="";followers=[];follow(e){for(let t of this.followers)t(e)}sceneSection(e,t){let n=new Ni("Shape",[],a=>this.store.change({shape:a}));this.followers.push(a=>{n.fill(e.names.map(l=>[l,vw[l]??l])),n.show(a.shape)});let r=this.choice("Up","up",[["y","y, as glTF has it"],["z","z, as Blender has it"]]);this.followers.push(a=>r.hidden=!e.isOwn(a.shape));let s=new Ni("Surroundings",[],a=>this.store.change({environment:a}));this.followers.push(a=>{s.fill([["studio","Studio"],["sky","Sky"],["dome","White dome"],["none","Nothing"],...this.skyName?[["own",this.skyName]]:[]]),s.show(a.environment)});let o=this.onOff("Dust lies where it settles","dust","tau by inclination and shelter instead of the same everywhere");return this.followers.push(()=>o.hidden=!t.all.some(a=>a?.tau)),mi("Scene",!0,Ee("div",{class:"motes-pair"},n.element,s.element),r,this.slider("lamp","lamp",{step:.05}),this.slider("lamp azimuth","lampAzimuth",{unit:"°",step:1}),this.slider("lamp height","lampElevation",{unit:"°",step:1}),this.slider("surroundings","sky",{step:.05}),this.slider("exposure","exposure",{unit:"EV",step:.1}),this.choice("Tone mapping","tone",[["neutral","Khronos PBR Neutral"],["agx","AgX"],["clip","Clip at 1"]]),o,this.onOff("Lobe in the corner","lobe","The BRDF in three dimensions"),this.onOff("Surroundings behind","backdrop","Show the environment as the background"),this.onOff("Ground","ground","The shadow on the ground of the light from all around; without surroundings behind"),Ee("p",{class:"motes-caption"},"Drag to turn, Shift-drag to move the lamp, scroll to zoom. The lamp is a point; light from the surroundings is the sum over up to 1,024 directions, finished some frames after the last change. The ground lacks the light from all around that the shape keeps from it; nothing else casts shadows. A .hdr or .exr panorama that is dropped becomes the surroundings."))}compareSection(e,t){let n=Ee("p",{class:"motes-caption"}),r=this.choice("Show","compare",[["one","One material"],["split","Two, split"],["side","Two, side by side"]]),s=this.slider("where it is split","split",{step:.01});return this.followers.push(o=>{r.querySelector("select").disabled=!e.two,s.hidden=!e.two||o.compare!=="split",qn(n,e.two?`Left: ${e.at(0).name}. Right: ${e.at(1).name}.`:"Open a second material (a material.json) to compare.")}),mi("Compare",e.cameWithTwo,r,s,n,t)}slider(e,t,n={}){let r=a=>this.store.change({[t]:_w(e,a,t)}),s=()=>this.store.change({[t]:this.start[t]}),o=new Li({label:e,...n,...$t[t],set:r,reset:s},this.fail);return this.followers.push(a=>o.show(a[t],a[t]!==this.start[t])),o.element}choice(e,t,n){let r=new Ni(e,n,s=>this.store.change({[t]:s}));return this.followers.push(s=>r.show(s[t])),r.element}onOff(e,t,n){let r=new ya(e,s=>this.store.change({[t]:s}),n);return this.followers.push(s=>r.show(s[t])),r.element}};function _w(i,e,t){let{low:n,high:r}=$t[t];if(!Number.isFinite(e))throw new oe(`${i} is not a number`,`Choose one from ${ut(n)} to ${ut(r)}`);return Un(e,n,r)}async function yw(i){try{await navigator.clipboard.writeText(i);return}catch{let e=Ee("textarea",{"aria-hidden":"true",tabindex:-1,class:"motes-offscreen"});e.value=i,document.body.append(e),e.select();let t=document.execCommand("copy");if(e.remove(),!t)throw new Error("The browser does not let this page copy")}}function Bf(i,e,t="text/plain"){let n=typeof e=="string"?new Blob([e],{type:t}):e,r=URL.createObjectURL(n),s=Ee("a",{href:r,download:i});document.body.append(s),s.click(),s.remove(),setTimeout(()=>URL.revokeObjectURL(r),1e4)}function xw(i){return i.replace(/[^\w.-]+/g,"-").replace(/^[-.]+|[-.]+$/g,"").slice(0,60)||"material"}function bw(i){let e=i;return i.width<i.clientWidth&&(e=Ee("canvas",{width:i.clientWidth,height:i.clientHeight}),e.getContext("2d")?.drawImage(i,0,0,e.width,e.height)),new Promise((t,n)=>e.toBlob(r=>r?t(r):n(new Error("The picture cannot be read"))))}function a0(i,e,t,n,r,s,o){let a=()=>t.active(i.state),l=f=>`${xw(a().name)}.${f}`,c=()=>{let{state:f}=i;return`${JSON.stringify(fd(a(),t.values(f,f.active),t.held(f,f.active),a().time?f.hours:null),null,1)}
`},h=(f,p)=>()=>{yw(p()).then(()=>r.say(`${f} is copied`),r.fail)},u=f=>{try{history.replaceState(null,"",f)}catch{}h("The link, which restores what you see,",()=>f)()};return mi("Take away",!0,Ee("div",{class:"motes-buttons"},Yn("Copy material",h("The material",c)),Yn("Save material",()=>Bf(l("json"),c(),"application/json")),Yn("Copy shader",h("The shader",()=>a().shader.source)),Yn("Save shader",()=>Bf(l("glsl"),a().shader.source)),Yn("Save picture",()=>{bw(n).then(f=>Bf(l("png"),f),r.fail)}),s?Yn("Copy link",()=>u(s())):null,o,Yn("Reset all",()=>i.change({...structuredClone(e),dropped:[null,null]}))),Ee("p",{class:"motes-caption"},"Open or drop a material.json, a table of measurements (CSV: theta_i, phi_i, theta_r, phi_r, channels) or a mesh (OBJ, PLY, GLB). Files stay in this page; nothing is sent and nothing is remembered."))}var Mw=8,jc=class{constructor(e,t){this.set=e;this.wake=t;let n=Pi("time");this.button=Ee("button",{type:"button",class:"motes-play","aria-label":"Play",onclick:()=>this.toggle()},"▶"),this.range=Ee("input",{type:"range",id:n,step:"any",class:"motes-range"}),this.range.addEventListener("input",()=>{this.pause(),this.set(Number(this.range.value))}),this.range.addEventListener("keydown",r=>{let s={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10}[r.key];if(s===void 0)return;r.preventDefault(),this.pause();let[o,a]=this.interval;this.set(Math.min(Math.max(Number(this.range.value)+s*(a-o)/100,o),a))}),this.element=Ee("div",{class:"motes-transport",role:"group","aria-label":"Time"},this.button,Ee("label",{for:n},"time"),this.range,this.words)}set;wake;element;button;range;words=Ee("output",{class:"motes-hours"});interval=[0,1];playing=!1;last=0;show(e,t){if(this.element.hidden=e===null,!e){this.pause();return}this.interval=e,this.range.min=String(e[0]),this.range.max=String(e[1]),this.range.value=String(t);let n=`${ut(t,3)} h`;this.range.setAttribute("aria-valuetext",n),qn(this.words,n)}toggle(){this.element.hidden||(this.playing?this.pause():(this.playing=!0,this.last=0,Number(this.range.value)>=this.interval[1]&&this.set(this.interval[0]),this.label("Pause","❚❚"),this.wake()))}pause(){this.playing=!1,this.label("Play","▶")}advance(e,t){if(!this.playing)return;let n=this.last?Math.min(e-this.last,200):0;this.last=e;let[r,s]=this.interval,o=t+(s-r)*n/1e3/Mw;this.set(o>s?r:o)}label(e,t){this.button.setAttribute("aria-label",e),qn(this.button,t)}};var[Sw,ww]=[250,140],eh=class{element=Ee("div",{class:"motes-trends"});charts=new Map;material=null;update(e,t,n){t!==this.material&&this.make(t);let r=t.time;if(!r)return;let s=r.hours;for(let[o,a]of Object.entries(r.trends)){let l=this.charts.get(o),c=t.slots.find(M=>M.name===o);if(!l||!c)continue;let u=a.values[0].length===1?[{channel:0,tint:"grey"}]:_i(t.channels,t.wavelengths),f=u.map(({channel:M})=>{let w=a.values.map(E=>E[M]),T=a.stderr?a.stderr.map(E=>E[M]??0):null;return{y:w,low:T?w.map((E,x)=>E-1.96*T[x]):w,high:T?w.map((E,x)=>E+1.96*T[x]):w}}),p=a.scans,[v,y]=[Math.min(...f.flatMap(M=>M.low)),Math.max(...f.flatMap(M=>M.high))];if(p)for(let M of p.values)for(let{channel:w}of u){let T=M[w];typeof T=="number"&&([v,y]=[Math.min(v,Math.max(T,v-(y-v))),Math.max(y,Math.min(T,y+(y-v)))])}let m=c.declared;v=Math.max(v,m.low),m.high!==null&&(y=Math.min(y,m.high));let g=(y-v)*.08||Math.abs(y)*.2||.1,A=`${o} over time: ${a.kind}, from ${Qc(a.values[0])} to ${Qc(a.values.at(-1))}; at ${ut(e.hours)} h ${Qc(n[o])}`;l.chart.begin(A,{low:s[0],high:s.at(-1),label:"hours"},{low:v-g,high:y+g,label:`${c.declared.symbol}${c.declared.unit?` (${c.declared.unit})`:""}`}),u.forEach(({channel:M,tint:w},T)=>{let{y:E,low:x,high:b}=f[T];if(a.stderr&&l.chart.band(s,x,b,w),p){let P=p.values.map(F=>F[M]??NaN),I=p.stderr.map(F=>F[M]??NaN);l.chart.bars(p.hours,P.map((F,B)=>F-I[B]),P.map((F,B)=>F+I[B]),w),l.chart.dots(p.hours,P,w)}l.chart.line({x:s,y:E,tint:w})}),l.chart.mark(e.hours),l.words.textContent=`${o}: ${a.kind.replaceAll("_"," ")}, now ${Qc(n[o])}${c.declared.unit?` ${c.declared.unit}`:""}`}}make(e){this.material=e,this.charts.clear();let t=Object.entries(e.time?.trends??{}),n=t.map(([a])=>{let l=new Er(`${a} over time`,ww,Sw),c=Ee("figcaption",{});return this.charts.set(a,{chart:l,words:c}),Ee("figure",{class:"motes-trend"},c,l.svg)}),r=t.some(([,a])=>a.stderr),s=t.some(([,a])=>a.scans),o=[r?"Bands: 95 %.":"No errors are known, so there are no bands.",s?"Dots: what each scan says on its own, with one standard error.":""].filter(Boolean).join(" ");this.element.replaceChildren(Ee("div",{class:"motes-multiples"},...n),Ee("p",{class:"motes-caption"},o))}},Qc=i=>i.length>4?`${ut(i[0],3)} … ${ut(i.at(-1),3)}`:i.map(e=>ut(e,3)).join(", ");var Aw=2,th=class{constructor(e,t,n){this.root=e;this.payload=t;this.host=n;nd(t.models),this.pair=new Hc(t),this.meshes=new kc(t.shapes),this.canvas=Ee("canvas",{tabindex:0,role:"application","aria-label":"The material on a shape. Arrow keys turn it, with Shift the lamp; plus and minus zoom; Space plays time."}),this.picture=new Kc(this.canvas),this.start=pd(t.shapes.shapes[0].name,this.pair.firstHours??0,this.pair.cameWithTwo),this.picture.setMaterials(this.pair.shown(this.start)),this.picture.prepare(this.start,this.pair.shownValues(this.start),this.meshes.get(this.start.shape,this.start.up)),this.data=t.measurement?zd(t.measurement):null,this.data&&(this.start.incidence=bh(this.data)),this.store=new wa(structuredClone(this.start)),this.picture.lobe=this.lobe,this.probe=new Xc(this.picture.renderer);let r=s=>this.store.change(s);this.parameters=new Gc((s,o)=>this.store.hold(this.store.state.active,s,o),this.messages.fail),this.reflection=new La(r),this.agreement=new Da(r,this.messages.fail),this.transport=new jc(s=>r({hours:s}),()=>this.request()),this.agreementSection=mi("Measured and computed",!0,this.agreement.element),this.trendSection=mi("Over time",!0,this.trends.element),this.stage=Ee("div",{class:"motes-stage"},this.canvas,...this.names,this.splitLine,this.progress),this.settings=new Jc(this.store,this.start,this.messages.fail,this.meshes,this.pair,Nf("Open second material…",".json",this,!0)),this.build(),kg(this.canvas,this.store),this.canvas.addEventListener("keydown",s=>{s.key===" "&&(s.preventDefault(),this.transport.toggle())}),this.observer=new ResizeObserver(()=>this.request()),this.observer.observe(this.stage),this.canvas.addEventListener("webglcontextlost",()=>this.contextLost()),this.canvas.addEventListener("webglcontextrestored",()=>this.contextRestored()),Pg(this.root,this,this.stop.signal),this.store.listen(s=>this.follow(s)),n.link&&(this.restore(),addEventListener("hashchange",()=>this.restore(),{signal:this.stop.signal})),this.rebuild(),this.followAll()}root;payload;host;store;start;picture;probe;messages=new zc;firstPicture=0;data=null;pair;meshes;settings;canvas;stage;title=Ee("h1");subtitle=Ee("p",{class:"motes-model"});lobe=new Bc;parameters;reflection;agreement;trends=new eh;transport;names=[Ee("span",{class:"motes-name left"}),Ee("span",{class:"motes-name right"})];progress=Ee("span",{class:"motes-progress"});tabs=Ee("div",{class:"motes-tabs",role:"group","aria-label":"Which material"});agreementSection;trendSection;splitLine=Ee("div",{class:"motes-cut"});observer;stop=new AbortController;pending=0;plotsDue=!0;lost=!1;material(e){return this.pair.at(e)}values(e){return this.pair.values(this.store.state,e)}evaluate(e,t,n){let r=this.pair.at(e);if(!r)throw new oe(`There is no material ${e}`,"Open a second one");return this.probe.evaluate(r,this.values(e),t,n)}environment(e){return e==="own"?this.picture.own??Vs("none"):Vs(e)}get relativeRms(){return this.agreement.relativeRms}openMaterial(e,t){let n=t?1:this.store.state.active,{material:r,notes:s}=this.pair.read(e),o=[...this.store.state.dropped],a=[...this.store.state.values];o[n]=e,a[n]={};let l=r.time&&!this.pair.interval(this.store.state)?r.time.interval[0]:this.store.state.hours;this.store.change({dropped:o,values:a,hours:l,...n===1?{compare:this.store.state.compare==="one"?"split":this.store.state.compare}:{}}),this.messages.say([`${r.name} is shown: ${r.json.model}`,...s].join(". "))}openData(e){this.data=e,this.messages.say(`${e.name}: ${e.count.toLocaleString("en")} pairs of directions are shown over the material. ${e.note}`.trim()),this.store.change({incidence:bh(e)}),this.followAll()}async openMesh(e,t){let{triangles:n,tau:r}=await this.meshes.add(e,t,this.store.state.up),{active:s}=this.store.state,o=this.pair.active(this.store.state).tau,a=r?o?`. Its own dust lies on it, tau up to ${ut(r)}, which the slider scales`:`. Its own dust, tau up to ${ut(r)}, is not shown: the material has no layer of dust`:"";this.messages.say(`${e} is shown: ${n.toLocaleString("en")} triangles${a}`),this.store.change({shape:e,...r&&o?{dust:!0}:{}}),r&&o&&this.store.hold(s,o,[r]),this.followAll()}openSky(e,t){this.picture.setOwn(t),this.settings.skyName=e,this.messages.say(`${e} lights the scene, as 64 x 128 cells`),this.store.change({environment:"own"}),this.followAll()}link(){return location.href.replace(/#.*$/s,"")+md(this.store.state,this.start)}apply(e){this.store.change(fh(this.start,e))}dispose(){cancelAnimationFrame(this.pending),this.observer.disconnect(),this.stop.abort(),this.transport.pause(),this.picture.dispose(),this.meshes.dispose()}build(){let e=Nf("Open file…",".json,.csv,.txt,.obj,.ply,.glb,.hdr,.exr",this,!1),t=a0(this.store,this.start,this.pair,this.canvas,this.messages,this.host.link?()=>this.link():null,e);for(let n of[this.settings.scene,this.settings.compare,t])n.classList.add("motes-controls");this.root.replaceChildren(Ee("header",{class:"motes-head"},this.title,this.subtitle,...this.payload.notes.map(n=>Ee("p",{class:"motes-note"},n))),Ee("div",{class:"motes-view"},this.stage,this.transport.element,this.messages.element),Ee("div",{class:"motes-panel"},mi("Parameters",!0,this.tabs,this.parameters.element),this.trendSection,mi("Reflection",!0,this.reflection.element),this.agreementSection,this.settings.scene,this.settings.compare,t,Ee("p",{class:"motes-foot"},`Motes ${this.payload.motes}. Shaded by GLSL that Motes printed from its equations; f in 1/sr, without the cosine. This page asks the network for nothing.`)))}restore(){let e=gd(location.hash,this.start);if(e){this.store.change(e);let t=[0,1].flatMap(n=>Object.keys(e.values[n]).filter(r=>!Object.hasOwn(this.pair.held(e,n),r)));t.length&&this.messages.fail(new oe(`The link sets ${Bt(t.join(", "))} to what the material cannot have; it is left out`,"Copy the link again"))}!e&&location.hash.startsWith("#motes=")&&this.messages.fail(new oe("The link is damaged and restores nothing","Copy it again"))}rebuild(){this.pair.follow(this.store.state,this.messages.fail),this.probe.keep(this.pair.all),this.tabs.replaceChildren(...this.pair.two?this.pair.all.map((e,t)=>Yn(e.name,()=>this.store.change({active:t}),{"data-active":String(t),"aria-pressed":"false"})):[])}followAll(){this.follow(new Set(Object.keys(this.store.state)))}follow(e){e.has("dropped")&&this.rebuild();let{state:t}=this.store;if(!this.pair.two&&(t.compare!=="one"||t.active!==0)){this.store.change({compare:"one",active:0});return}(e.has("shape")||e.has("dropped")||e.has("up"))&&this.picture.setGeometry(this.meshes.get(t.shape,t.up)),["dropped","compare","active"].some(s=>e.has(s))&&this.picture.setMaterials(this.pair.shown(t)),this.settings.follow(t),this.words(t),[...e].every(s=>["exposure","tone","incidence","lobe","radius","scale","active"].includes(s))||this.picture.restart(),this.picture.stale=!0;let r=new Set(["azimuth","elevation","distance","lampAzimuth","lampElevation","lamp","environment","sky","exposure","tone","split","dust","backdrop","ground","up","shape"]);[...e].every(s=>r.has(s))||(this.plotsDue=!0),this.host.changed?.(t),this.request()}words(e){let t=this.pair.shown(e);qn(this.title,t.map(r=>r.name).join(" and ")),qn(this.subtitle,[...new Set(t.map(r=>r.json.model))].join(" · ")),this.names.forEach((r,s)=>{r.hidden=t.length<2,qn(r,t[s]?.name??"")}),this.splitLine.hidden=t.length<2,this.splitLine.style.left=`${100*(e.compare==="side"?.5:e.split)}%`;for(let r of Array.from(this.tabs.children))r.setAttribute("aria-pressed",String(r.getAttribute("data-active")===String(e.active)));let n=this.pair.active(e);this.parameters.show(n,this.values(e.active),this.pair.held(e,e.active)),this.transport.show(this.pair.interval(e),e.hours),this.trendSection.hidden=!n.time,this.agreementSection.hidden=!this.data}request(){!this.pending&&!this.lost&&(this.pending=requestAnimationFrame(e=>this.frame(e)))}frame(e){if(this.pending=0,this.lost)return;this.transport.advance(e,this.store.state.hours);let{state:t}=this.store,n=Math.min(devicePixelRatio||1,Aw);if(this.stage.style.setProperty("--aspect",String(this.stage.clientWidth/Math.max(this.stage.clientHeight,1))),this.picture.resize(this.stage.clientWidth,this.stage.clientHeight,n),this.plotsDue&&this.firstPicture&&this.plots(t),this.lobe.visible=t.lobe&&this.firstPicture>0,this.picture.draw(t,this.pair.shownValues(t)),!this.firstPicture){let s=this.picture.renderer.getContext();s.readPixels(0,0,1,1,s.RGBA,s.UNSIGNED_BYTE,new Uint8Array(4)),this.firstPicture=performance.now(),this.root.dataset.firstPicture=this.firstPicture.toFixed(0)}qn(this.progress,this.picture.complete?"":`${Math.round(100*this.picture.progress)} %`);let r=String(this.picture.complete&&!this.plotsDue);this.root.dataset.complete!==r&&(this.root.dataset.complete=r),(!this.picture.complete||this.plotsDue||this.transport.playing)&&this.request()}plots(e){this.plotsDue=!1,this.picture.stale=!0;let t=this.pair.all.filter(s=>s!==null),n=t.map((s,o)=>this.values(o)),r=t[e.active];if(this.lobe.update(e,r,n[e.active],this.probe),this.reflection.update(e,t,n,this.probe,this.data),this.data)try{this.agreement.update(e,t[0],n[0],this.probe,this.data)}catch(s){this.messages.fail(s)}r.time&&this.trends.update(e,r,n[e.active])}contextLost(){this.lost=!0,cancelAnimationFrame(this.pending),this.pending=0,this.messages.say("The graphics device was lost; the picture comes back with it")}contextRestored(){this.lost=!1,this.picture.revive(),this.probe.revive(),this.plotsDue=!0,this.messages.say("The graphics device is back"),this.request()}};function h0(i,e,t){let n=e;try{if(!hn(e)||e.format!=="motes view"||e.version!==2)throw new oe("The data of this page are of another version of Motes","Write it again with motes view");return i.motes=new th(i,n,t),i.motes}catch(r){let[s,o]=r instanceof oe?[r.message,r.hint]:[`The viewer cannot start: ${r instanceof Error?r.message:String(r)}`,"The pictures below stand in for it"];return i.querySelector(".motes-why")?.remove(),i.prepend(Ee("p",{class:"motes-message failed",role:"alert"},`${s}. ${o}.`)),null}}function Ew({model:i,el:e}){let t=Ee("div",{class:"motes motes-widget"});e.append(t);let n="",r=h0(t,i.get("payload"),{link:!1,changed:o=>{n=JSON.stringify(o),i.set("state",JSON.parse(n)),i.save_changes()}}),s=()=>{let o=i.get("state");r&&hn(o)&&JSON.stringify(o)!==n&&r.apply(o)};return i.on("change:state",s),()=>{i.off("change:state",s),r?.dispose()}}var l0=document.getElementById("motes-data"),c0=document.getElementById("motes");l0&&c0&&h0(c0,JSON.parse(l0.textContent??"null"),{link:!0});var RI={render:Ew};export{RI as default};
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
