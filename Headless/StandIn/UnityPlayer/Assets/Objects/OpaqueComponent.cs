using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A component whose class the stand-in does not have. It stores all fields unchanged.</summary>
sealed class OpaqueComponent : Component
{
    /// <summary>Name of the component's class in Unity.</summary>
    public string ClassName { get; set; }

    public YamlMappingNode Fields { get; } = new YamlMappingNode();
}
