using System;

namespace Nowpose.Latency
{
    /// <summary>The same L_visu for every frame, as it was calibrated.</summary>
    public sealed class CalibratedDisplayTime : IDisplayTimeSource
    {
        readonly VisualisationLatency _visualisation;

        public CalibratedDisplayTime(LatencyProfile profile) =>
            _visualisation = (profile ?? throw new ArgumentNullException(nameof(profile))).Visualisation;

        public HeadsetTime? LightOf(HeadsetTime frameStart) => _visualisation.LightOf(frameStart);
    }
}
