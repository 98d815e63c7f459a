using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>A component that the stand-in has no class for and nothing here asks about: its fields are kept as they are.</summary>
sealed class OpaqueComponent : Component
{
    /// <summary>Which class it would be.</summary>
    public string ClassName { get; set; }

    public YamlMappingNode Fields { get; } = new YamlMappingNode();
}
