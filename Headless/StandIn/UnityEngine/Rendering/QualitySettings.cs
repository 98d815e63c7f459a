using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class QualitySettings : Object
{
    QualitySettings() { }

    /// <summary>Render pipeline of the current quality level; null for the default one.</summary>
    public static RenderPipelineAsset renderPipeline { get; set; }
}
