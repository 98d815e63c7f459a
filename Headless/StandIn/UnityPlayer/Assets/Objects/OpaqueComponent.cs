using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A component of a class that the stand-in does not implement. It stores all fields unchanged.</summary>
sealed class OpaqueComponent : Component
{
    /// <summary>Name of the component's class in Unity.</summary>
    public string ClassName { get; set; }

    public YamlMappingNode Fields { get; } = new YamlMappingNode();
}
