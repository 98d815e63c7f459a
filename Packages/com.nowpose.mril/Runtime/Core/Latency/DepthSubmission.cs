namespace Nowpose.Latency
{
    /// <summary>Whether the depth buffer of a frame reaches the display, which needs it to correct each surface for head motion.</summary>
    public enum DepthSubmission
    {
        /// <summary>Nothing reports it, or no headset's display runs.</summary>
        Unknown = 0,

        /// <summary>Depth is submitted.</summary>
        Active,

        /// <summary>The project's Depth Submission Mode is None.</summary>
        TurnedOff,

        /// <summary>The runtime lacks the extension XR_KHR_composition_layer_depth, or it was not enabled.</summary>
        NotSupported,

        /// <summary>No enabled camera has the tag MainCamera: its near and far planes give the depth buffer its scale.</summary>
        NoMainCamera,

        /// <summary>The display does not ask Unity to fill its depth buffer, though it is turned on and supported.</summary>
        NotRequested,
    }
}
