using System.Runtime.CompilerServices;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Reads and writes materials. A file contains exactly the properties that the shader of the material declares.</summary>
static class MaterialClass
{
    public const long FileId = 2100000;

    static readonly ConditionalWeakTable<Shader, ShaderDeclaration> Declarations = new ConditionalWeakTable<Shader, ShaderDeclaration>();

    public static ObjectClass Class { get; } = new ObjectClass(21, "Material", typeof(Material), Slots().ToArray());

    public static Shader NewShader(ShaderDeclaration declaration)
    {
        var shader = new Shader { name = declaration.Name, Tags = declaration.Tags };
        Declarations.Add(shader, declaration);
        return shader;
    }

    /// <summary>Sets the shader of a material. Also sets the properties to the default values that the shader declares.</summary>
    public static void SetShader(Material material, Shader shader)
    {
        material.shader = shader;
        if (!Declarations.TryGetValue(shader, out var declaration)) return;
        foreach (var (name, value) in declaration.Floats) material.SetFloat(name, value);
        foreach (var (name, value) in declaration.Colours) material.SetColor(name, value);
    }

    static IEnumerable<Slot> Slots()
    {
        return Headers.Object.Prepend(Slot.Constant("serializedVersion", Nodes.Number(8))).Concat(new[]
        {
            Slot.Property("m_Name", (Material m) => m.name, (m, v) => m.name = v),
            Slot.Property("m_Shader", (Material m) => m.shader, SetShader),
            Slot.Constant("m_ValidKeywords", Nodes.List()),
            Slot.Constant("m_InvalidKeywords", Nodes.List()),
            Slot.Constant("m_LightmapFlags", Nodes.Number(4)),
            Slot.Property("m_EnableInstancingVariants", (Material m) => m.enableInstancing, (m, v) => m.enableInstancing = v),
            Slot.Constant("m_DoubleSidedGI", Nodes.Number(0)),
            Slot.Property("m_CustomRenderQueue", (Material m) => m.OwnRenderQueue, (m, v) => m.OwnRenderQueue = v),
            Slot.Constant("stringTagMap", Nodes.Braces()),
            Slot.Constant("disabledShaderPasses", Nodes.List()),
            Slot.Property("m_SavedProperties", (Material m) => m, (_, _) => { }, new SavedProperties()),
        });
    }

    sealed class SavedProperties : IValueFormat
    {
        static readonly IValueFormat Float = ValueFormats.For(typeof(float));
        static readonly IValueFormat Colour = ValueFormats.For(typeof(Color));

        public object Read(YamlNode node, object current, FileReferences references, Place place)
        {
            var material = (Material)current;
            var declared = DeclarationOf(material, place);
            foreach (var entry in place.Mapping(node).Children)
            {
                var list = place.Scalar(entry.Key);
                switch (list)
                {
                    case "m_Floats":
                        ReadEach(entry.Value, declared.Floats, place.In(list),
                            (name, v, at) => material.SetFloat(name, (float)Float.Read(v, null, references, at)));
                        break;
                    case "m_Colors":
                        ReadEach(entry.Value, declared.Colours, place.In(list),
                            (name, v, at) => material.SetColor(name, (Color)Colour.Read(v, null, references, at)));
                        break;
                    case "serializedVersion" when place.In(list).Scalar(entry.Value) == "3":
                    case "m_TexEnvs" or "m_Ints" when place.In(list).Sequence(entry.Value).Children.Count == 0:
                        break;
                    default:
                        throw place.In(list).Error(AssetFault.Unsupported, "is not supported by the stand-in");
                }
            }
            return material;
        }

        public YamlNode Write(object value, FileReferences references, Place place)
        {
            var material = (Material)value;
            var declared = DeclarationOf(material, place);
            return Nodes.Lines(
                ("serializedVersion", Nodes.Number(3)),
                ("m_TexEnvs", Nodes.List()),
                ("m_Ints", Nodes.List()),
                ("m_Floats", WriteEach(declared.Floats, name => Float.Write(material.GetFloat(name), references, place))),
                ("m_Colors", WriteEach(declared.Colours, name => Colour.Write(material.GetColor(name), references, place))));
        }

        static ShaderDeclaration DeclarationOf(Material material, Place place) =>
            material.shader != null && Declarations.TryGetValue(material.shader, out var found)
                ? found
                : throw place.Error(AssetFault.Unsupported, "the properties of its shader are not known here");

        /// <summary>Reads a list whose items are pairs of a property name and a value.</summary>
        static void ReadEach<T>(YamlNode node, IReadOnlyDictionary<string, T> declared, Place place, Action<string, YamlNode, Place> set)
        {
            foreach (var entry in place.Sequence(node).Children.SelectMany(i => place.Mapping(i).Children))
            {
                var name = place.Scalar(entry.Key);
                if (!declared.ContainsKey(name)) throw place.In(name).Error(AssetFault.UnknownField, "the shader declares no such property");
                set(name, entry.Value, place.In(name));
            }
        }

        static YamlSequenceNode WriteEach<T>(IReadOnlyDictionary<string, T> declared, Func<string, YamlNode> value) =>
            new YamlSequenceNode(declared.Keys.OrderBy(n => n, StringComparer.Ordinal).Select(n => Nodes.Lines((n, value(n)))));
    }
}
