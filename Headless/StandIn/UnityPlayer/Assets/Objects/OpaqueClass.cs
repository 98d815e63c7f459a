using Nowpose.UnityPlayer.Assets.Values;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Class of an <see cref="OpaqueComponent"/>.</summary>
sealed class OpaqueClass(int id, string name) : ObjectClass(id, name, typeof(OpaqueComponent), Headers.Component.ToArray())
{
    protected override void ReadOther(string name, YamlNode node, Object target, FileReferences references, Place place) =>
        ((OpaqueComponent)target).Fields.Add(name, node);

    protected override IEnumerable<(string Name, YamlNode Value)> WriteOthers(Object source) =>
        ((OpaqueComponent)source).Fields.Children.Select(f => (((YamlScalarNode)f.Key).Value, f.Value));
}
