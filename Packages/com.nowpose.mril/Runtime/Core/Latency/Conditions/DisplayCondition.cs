namespace Nowpose.Latency.Conditions
{
    /// <summary>A condition that affects L_visu, the visualisation latency.</summary>
    enum DisplayCondition
    {
        /// <summary>Model of the headset.</summary>
        Device,

        /// <summary>Refresh rate of the display, Hz.</summary>
        DisplayRate,

        /// <summary>Graphics API, such as Direct3D11.</summary>
        GraphicsApi,

        /// <summary>Rendering threading mode of Unity: with or without Graphics Jobs.</summary>
        GraphicsJobs,

        /// <summary>Unity's render pipeline.</summary>
        RenderPipeline,

        /// <summary>Whether the pose is computed a second time right before rendering.</summary>
        RewriteBeforeRender,

        /// <summary>OpenXR's Latency Optimization setting, which changes when Unity waits for the next frame.</summary>
        LatencyOptimization,

        /// <summary>Method by which the display corrects a finished frame for head motion.</summary>
        Reprojection,
    }
}
