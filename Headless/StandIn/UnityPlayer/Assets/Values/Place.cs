namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>A place in a file, for error messages. Example: <c>Arm.prefab &amp;12 Light.m_Color</c>.</summary>
readonly struct Place(string text)
{
    public Place In(string field) => new Place(text + "." + field);

    public Place At(int index) => new Place(text + "[" + index + "]");

    public AssetException Error(AssetFault fault, string message) => new AssetException(fault, text + ": " + message);

    public string Scalar(YamlNode node) =>
        node is YamlScalarNode scalar ? scalar.Value ?? "" : throw Error(AssetFault.Kind, "has to be one value, not " + Kind(node));

    public YamlMappingNode Mapping(YamlNode node) =>
        node as YamlMappingNode ?? throw Error(AssetFault.Kind, "has to be named values, not " + Kind(node));

    /// <summary>Returns a node as a list. An empty list is also a list node, because Unity writes it as <c>[]</c>.</summary>
    public YamlSequenceNode Sequence(YamlNode node) =>
        node as YamlSequenceNode ?? throw Error(AssetFault.Kind, "has to be a list, not " + Kind(node));

    public override string ToString() => text;

    static string Kind(YamlNode node) => node switch
    {
        YamlScalarNode scalar => "\"" + scalar.Value + "\"",
        YamlMappingNode _ => "named values",
        YamlSequenceNode _ => "a list",
        _ => "nothing",
    };
}
