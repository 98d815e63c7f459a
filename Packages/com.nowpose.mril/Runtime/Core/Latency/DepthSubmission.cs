namespace Nowpose.Latency
{
    /// <summary>Whether the depth buffer of a frame reaches the display, which uses it to correct each surface for head motion.</summary>
    public enum DepthSubmission
    {
        /// <summary>The state is not reported, or no headset display is running.</summary>
        Unknown = 0,

        /// <summary>Depth is submitted.</summary>
        Active,

        /// <summary>The project's Depth Submission Mode is None.</summary>
        TurnedOff,

        /// <summary>The runtime does not support the extension XR_KHR_composition_layer_depth, or the extension was not enabled.</summary>
        NotSupported,

        /// <summary>No enabled camera has the tag MainCamera. The near and far planes of that camera define the scale of the depth buffer.</summary>
        NoMainCamera,

        /// <summary>The display does not request that Unity fill its depth buffer, although depth submission is turned on and supported.</summary>
        NotRequested,
    }
}
