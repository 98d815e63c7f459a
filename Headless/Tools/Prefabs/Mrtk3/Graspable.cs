using MixedReality.Toolkit;
using MixedReality.Toolkit.SpatialManipulation;
using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Makes objects movable and rotatable with hands, rays, and gaze and pinch.</summary>
static class Graspable
{
    /// <param name="host">Object that is moved; null to move the graspable object itself.</param>
    /// <param name="size">Size of the box in which the object can be grasped, m.</param>
    public static ObjectManipulator Make(GameObject made, Transform host, Vector3 size)
    {
        var box = made.AddComponent<OpaqueComponent>();
        box.ClassName = "BoxCollider";
        foreach (var (name, value) in BoxFields(size).Children) box.Fields.Add(name, value);
        var manipulator = made.AddComponent<ObjectManipulator>();
        Fields.Set(manipulator, "hostTransform", host != null ? host : made.transform);
        manipulator.AllowedManipulations = TransformFlags.Move | TransformFlags.Rotate;
        // Disables selection by voice, because a voice command can only click the object and not move it.
        Fields.Set(manipulator, "allowSelectByVoice", false);
        return manipulator;
    }

    static YamlDotNet.RepresentationModel.YamlMappingNode BoxFields(Vector3 size) => Nodes.Lines(
        ("m_Material", AssetReference.None.Write()),
        ("m_IsTrigger", Nodes.Number(0)),
        ("m_Enabled", Nodes.Number(1)),
        ("serializedVersion", Nodes.Number(2)),
        ("m_Size", Nodes.Braces(("x", Metres(size.x)), ("y", Metres(size.y)), ("z", Metres(size.z)))),
        ("m_Center", Nodes.Braces(("x", Nodes.Number(0)), ("y", Nodes.Number(0)), ("z", Nodes.Number(0)))));

    static YamlDotNet.RepresentationModel.YamlScalarNode Metres(float length) => Nodes.Text(Numbers.Write(length));
}
