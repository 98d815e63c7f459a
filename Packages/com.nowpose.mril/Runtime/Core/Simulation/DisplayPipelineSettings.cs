namespace Nowpose.Simulation
{
    /// <summary>Settings of a <see cref="DisplayPipeline"/>. Immutable. Limits in tests depend on the defaults.</summary>
    sealed class DisplayPipelineSettings
    {
        /// <summary>Time before a refresh by which its frame must be done, ms.</summary>
        public const double LatchMs = 1.5;

        /// <summary>Render time of an empty scene, ms.</summary>
        public const double BaseMs = 4;

        /// <param name="refreshMs">Refresh interval, ms; 60 Hz by default.</param>
        /// <param name="msPerMillion">Additional render time per million vertices, ms.</param>
        /// <param name="scatter">Relative standard deviation of the render times.</param>
        /// <param name="spikeChance">Probability that a frame takes 1.5 to 2.5 times as long.</param>
        /// <param name="plateauMs">
        /// L_visu of a frame that meets the next refresh, ms, at least <paramref name="refreshMs"/>: the time from the latch to the middle of the
        /// display duration (composition, scan-out and half the display duration) is the same for every frame.
        /// </param>
        public DisplayPipelineSettings(
            double refreshMs = 1000 / 60.0, double msPerMillion = 8.5, double scatter = 0.03, double spikeChance = 0.01, double plateauMs = 40) =>
            (RefreshMs, MsPerMillion, Scatter, SpikeChance, PlateauMs) = (refreshMs, msPerMillion, scatter, spikeChance, plateauMs);

        public double RefreshMs { get; }
        public double MsPerMillion { get; }
        public double Scatter { get; }
        public double SpikeChance { get; }
        public double PlateauMs { get; }

        /// <summary>Returns the number of vertices for a render time without scatter; negative for a time below <see cref="BaseMs"/>.</summary>
        public double VerticesOf(double renderMs) => (renderMs - BaseMs) / MsPerMillion * 1e6;
    }
}
