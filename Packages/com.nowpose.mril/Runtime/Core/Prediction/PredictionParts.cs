using System;

namespace Nowpose.Prediction
{
    /// <summary>Parts of the pipeline that can be switched off, for the ablation study (prediction.md, prediction-reference.md).</summary>
    [Flags]
    enum PredictionParts
    {
        /// <summary>The paper's pipeline: one forecaster on the unmodified samples.</summary>
        None = 0,

        /// <summary>Corrects stamps of a periodic source.</summary>
        StampCorrection = 1,

        /// <summary>Skips samples less than 5.5 ms apart.</summary>
        Thinning = 2,

        /// <summary>Interpolates the position between samples.</summary>
        Interpolation = 4,

        /// <summary>All parts that prepare samples; the paper's polynomials use none of them.</summary>
        Samples = StampCorrection | Thinning | Interpolation,

        /// <summary>The quadratic through five samples.</summary>
        Quadratic = 8,

        Cubic = 16,

        /// <summary>The Gaussian process.</summary>
        Process = 32,

        /// <summary>The parabola from reported velocity and acceleration, or through three samples if they are not reported.</summary>
        Reported = 64,

        /// <summary>Template matching with the motion of the last two minutes.</summary>
        Repetition = 128,

        /// <summary>S-curve profiles if the drive's limits are known.</summary>
        Profiles = 256,

        /// <summary>Ignores samples before a change point.</summary>
        ChangePoints = 512,

        /// <summary>Uses separate weights at rest.</summary>
        RestWeights = 1024,

        /// <summary>Limits errors by an outlier threshold.</summary>
        OutlierThreshold = 2048,

        /// <summary>A first move, which is much faster than the previous motion, starts with a line and continues with the prior weights.</summary>
        FirstMoves = 4096,

        All = Samples | Quadratic | Cubic | Process | Reported | Repetition | Profiles | ChangePoints | RestWeights | OutlierThreshold | FirstMoves
    }
}
