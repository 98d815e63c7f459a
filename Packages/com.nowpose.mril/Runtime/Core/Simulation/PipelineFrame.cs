using System;

namespace Nowpose.Simulation
{
    /// <summary>How one frame passed through a <see cref="DisplayPipeline"/>.</summary>
    readonly struct PipelineFrame
    {
        internal PipelineFrame(TimeSpan start, TimeSpan renderTime, TimeSpan done, TimeSpan visualisation)
        {
            Start = start;
            RenderTime = renderTime;
            Done = done;
            Visualisation = visualisation;
        }

        /// <summary>Since the pipeline began: its render job is triggered, at a refresh.</summary>
        public TimeSpan Start { get; }

        /// <summary>Δt_render: how long the GPU worked on it.</summary>
        public TimeSpan RenderTime { get; }

        /// <summary>Since the pipeline began: the GPU has finished it. Only now can a program know the render time.</summary>
        public TimeSpan Done { get; }

        /// <summary>L_visu: from the trigger to the middle of its light.</summary>
        public TimeSpan Visualisation { get; }
    }
}
