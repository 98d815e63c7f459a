using Nowpose.Messages;

namespace Nowpose.Simulation
{
    /// <summary>Settings of a <see cref="DisplayPipeline"/>. Immutable; checked in the constructor. Limits in tests depend on the defaults.</summary>
    sealed class DisplayPipelineSettings
    {
        /// <param name="refreshMs">Refresh interval, ms, 1 to 100; 60 Hz by default.</param>
        /// <param name="latchMs">Time before a refresh by which its frame must be done, ms, 0 to 0.99 refreshes.</param>
        /// <param name="baseMs">Render time of an empty scene, ms, 0.1 to 100.</param>
        /// <param name="msPerMillion">Additional render time per million vertices, ms, 0 to 1000.</param>
        /// <param name="scatter">Relative standard deviation of the render times, 0 to 0.2.</param>
        /// <param name="spikeChance">Probability that a frame takes 1.5 to 2.5 times as long, 0 to 1.</param>
        /// <param name="plateauMs">
        /// L_visu of a frame that meets the next refresh, ms, from <paramref name="refreshMs"/> to 500: the time from the latch to the middle of the
        /// display duration (composition, scan-out and half the display duration) is the same for every frame.
        /// </param>
        /// <exception cref="InputException">A value is out of range.</exception>
        public DisplayPipelineSettings(
            double refreshMs = 1000 / 60.0, double latchMs = 1.5, double baseMs = 4, double msPerMillion = 8.5, double scatter = 0.03,
            double spikeChance = 0.01, double plateauMs = 40)
        {
            RefreshMs = SettingRange.Require(refreshMs, 1, 100, "refresh interval", "ms");
            LatchMs = SettingRange.Require(latchMs, 0, 0.99 * refreshMs, SettingNames.Latch, "ms");
            BaseMs = SettingRange.Require(baseMs, 0.1, 100, SettingNames.EmptySceneRenderTime, "ms");
            MsPerMillion = SettingRange.Require(msPerMillion, 0, 1000, SettingNames.RenderTimePerVertices, "ms");
            Scatter = SettingRange.Require(scatter, 0, 0.2, SettingNames.RenderTimeScatter, "");
            SpikeChance = SettingRange.Require(spikeChance, 0, 1, SettingNames.SlowFrameChance, "");
            PlateauMs = SettingRange.Require(plateauMs, refreshMs, 500, SettingNames.VisualisationInTime, "ms");
        }

        public double RefreshMs { get; }
        public double LatchMs { get; }
        public double BaseMs { get; }
        public double MsPerMillion { get; }
        public double Scatter { get; }
        public double SpikeChance { get; }
        public double PlateauMs { get; }

        /// <summary>Returns the number of vertices for a render time without scatter; negative for a time below <see cref="BaseMs"/>.</summary>
        public double VerticesOf(double renderMs) => (renderMs - BaseMs) / MsPerMillion * 1e6;
    }
}
