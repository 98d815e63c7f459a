using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class QualitySettings : Object
{
    QualitySettings() { }

    /// <summary>Render pipeline of the current quality level; null for the default pipeline.</summary>
    public static RenderPipelineAsset renderPipeline { get; set; }
}
