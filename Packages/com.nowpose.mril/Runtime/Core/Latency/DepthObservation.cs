namespace Nowpose.Latency
{
    /// <summary>Conditions of depth submission at one time.</summary>
    readonly struct DepthObservation
    {
        public DepthObservation(bool isRunning, bool isTurnedOn, bool isSupported, bool hasMainCamera, bool? isRequested) =>
            (IsRunning, IsTurnedOn, IsSupported, HasMainCamera, IsRequested) = (isRunning, isTurnedOn, isSupported, hasMainCamera, isRequested);

        /// <summary>Whether a headset display is running through OpenXR.</summary>
        public bool IsRunning { get; }

        /// <summary>Whether the current Depth Submission Mode differs from None.</summary>
        public bool IsTurnedOn { get; }

        /// <summary>Whether the runtime has enabled XR_KHR_composition_layer_depth.</summary>
        public bool IsSupported { get; }

        /// <summary>Whether an enabled camera has the tag MainCamera.</summary>
        public bool HasMainCamera { get; }

        /// <summary>Whether a render pass of the display requests depth; null before the first frame.</summary>
        public bool? IsRequested { get; }

        /// <returns>State for the first condition that is not met; <see cref="DepthSubmission.Active"/> if all are met.</returns>
        public DepthSubmission Judge()
        {
            if (!IsRunning) return DepthSubmission.Unknown;
            if (!IsTurnedOn) return DepthSubmission.TurnedOff;
            if (!IsSupported) return DepthSubmission.NotSupported;
            if (!HasMainCamera) return DepthSubmission.NoMainCamera;
            if (IsRequested == null) return DepthSubmission.Unknown;
            return IsRequested.Value ? DepthSubmission.Active : DepthSubmission.NotRequested;
        }
    }
}
