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
        Preparation = StampCorrection | Thinning | Interpolation,

        /// <summary>The quadratic through three samples.</summary>
        Quadratic = 8,

        /// <summary>The cubic through four samples.</summary>
        Cubic = 16,

        /// <summary>The least-squares fit of a quadratic to five samples.</summary>
        QuadraticOfFive = 32,

        /// <summary>The fit of a quadratic to ten samples.</summary>
        QuadraticOfTen = 64,

        /// <summary>The fit of a cubic to six samples.</summary>
        CubicOfSix = 128,

        /// <summary>The fit of a line to ten samples.</summary>
        LineOfTen = 256,

        /// <summary>The Gaussian process.</summary>
        Process = 512,

        /// <summary>The parabola from reported velocity and acceleration, instead of the quadratic through three samples.</summary>
        Reported = 1024,

        /// <summary>Template matching with the motion of the last two minutes.</summary>
        Repetition = 2048,

        /// <summary>S-curve profiles if the drive's limits are known.</summary>
        Profiles = 4096,

        /// <summary>Ignores samples before a change point.</summary>
        ChangePoints = 8192,

        /// <summary>Predicts the mean of samples that only scatter.</summary>
        Scatter = 16384,

        /// <summary>Leaves wrong samples out, and detects positions that jump.</summary>
        Jumps = 32768,

        /// <summary>Limits the distance of a forecast from the line.</summary>
        DistanceLimit = 65536,

        /// <summary>Predicts that a move brakes as it has accelerated.</summary>
        Braking = 131072,

        /// <summary>Multiplies the prior of the mixture by the persistence of the motion; hold has the remainder.</summary>
        Persistence = 262144,

        /// <summary>The parts for joints and objects.</summary>
        Common = Preparation | Quadratic | Cubic | QuadraticOfFive | CubicOfSix | QuadraticOfTen | Process | Repetition | Braking | ChangePoints | Scatter
            | Jumps | DistanceLimit,

        /// <summary>All parts for a joint.</summary>
        Joint = Common | Reported | Profiles,

        /// <summary>All parts for an object, whose tracker may be noisy.</summary>
        Object = Common | LineOfTen | Persistence
    }
}
