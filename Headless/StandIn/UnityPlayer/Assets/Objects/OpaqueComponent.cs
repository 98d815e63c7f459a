namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A component of a class that the stand-in does not implement. It stores all fields unchanged.</summary>
sealed class OpaqueComponent : Component
{
    /// <summary>Name of the component's class in Unity.</summary>
    public string ClassName { get; set; }

    public YamlMappingNode Fields { get; } = new YamlMappingNode();
}

/// <summary>Class of an <see cref="OpaqueComponent"/>.</summary>
sealed class OpaqueClass(int id, string name) : ObjectClass(id, name, typeof(OpaqueComponent), Headers.Component.ToArray())
{
    protected override void ReadOther(string name, YamlNode node, Object target, FileReferences references, Place place) =>
        ((OpaqueComponent)target).Fields.Add(name, node);

    protected override IEnumerable<(string Name, YamlNode Value)> WriteOthers(Object source) =>
        ((OpaqueComponent)source).Fields.Children.Select(f => (((YamlScalarNode)f.Key).Value, f.Value));
}
