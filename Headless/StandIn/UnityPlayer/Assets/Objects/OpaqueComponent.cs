using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A component without a class in the stand-in. Its fields are kept unchanged.</summary>
sealed class OpaqueComponent : Component
{
    /// <summary>Name of its class.</summary>
    public string ClassName { get; set; }

    public YamlMappingNode Fields { get; } = new YamlMappingNode();
}
