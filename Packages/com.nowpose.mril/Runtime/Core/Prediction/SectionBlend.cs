using System;

namespace Nowpose.Prediction
{
    /// <summary>What a displayed position still keeps of the section before, so that a new section does not make it jump.</summary>
    /// <remarks>
    /// The difference between what was shown last and what the new section says of that same moment decays with
    /// exp(−Δt/τ). A part of it that is still decaying when the next section comes is in what was shown, and so carried on.
    /// </remarks>
    struct SectionBlend
    {
        double _residual;
        double _start;
        double _perTimeConstant;

        /// <param name="at">When the position was shown, s.</param>
        /// <param name="residual">What was shown minus what the new section says of then.</param>
        /// <param name="timeConstant">τ, s, more than 0.</param>
        public void Start(double at, double residual, double timeConstant)
        {
            _start = at;
            _residual = residual;
            _perTimeConstant = 1 / timeConstant;
        }

        public void Clear() => _residual = 0;

        /// <summary>What is to be added to the section's value.</summary>
        public double At(double time) => _residual == 0 ? 0 : _residual * Math.Exp(-Math.Max(time - _start, 0) * _perTimeConstant);
    }
}
