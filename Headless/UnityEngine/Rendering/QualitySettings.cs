using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class QualitySettings : Object
{
    QualitySettings() { }

    /// <summary>Of the current level; null for the project's default.</summary>
    public static RenderPipelineAsset renderPipeline { get; set; }
}
