using System;

namespace Nowpose.Simulation
{
    /// <summary>Times of one frame in a <see cref="DisplayPipeline"/>.</summary>
    readonly struct PipelineFrame
    {
        internal PipelineFrame(TimeSpan start, TimeSpan renderTime, TimeSpan done, TimeSpan visualisation, long refresh) =>
            (Start, RenderTime, Done, Visualisation, Refresh) = (start, renderTime, done, visualisation, refresh);

        /// <summary>Time since the pipeline's start at which the render job is triggered: at a refresh, or when the queue has room.</summary>
        public TimeSpan Start { get; }

        /// <summary>Δt_render: duration of the GPU's work on the frame.</summary>
        public TimeSpan RenderTime { get; }

        /// <summary>Time since the pipeline's start at which the GPU has finished the frame. A program cannot read the render time earlier.</summary>
        public TimeSpan Done { get; }

        /// <summary>L_visu: from the trigger to the middle of the frame's display duration.</summary>
        public TimeSpan Visualisation { get; }

        /// <summary>Number of the refresh at which the frame is ready for display, counted from the pipeline's start.</summary>
        public long Refresh { get; }

        /// <summary>Returns whether the next frame is ready for the same refresh, so that this frame is never displayed.</summary>
        public bool IsReplacedBy(PipelineFrame next) => next.Refresh == Refresh;
    }
}
