using System.Collections.Generic;
using Nowpose.Prediction;
using Nowpose.Sync;
using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Shows a string field in the Inspector as a drop-down of names; the name itself is serialised.</summary>
    abstract class NameChoiceAttribute : PropertyAttribute
    {
        /// <summary>The names to choose from. The field may contain another one, for example from an older asset or a script.</summary>
        public abstract IReadOnlyList<string> Names { get; }
    }

    sealed class PredictorNameAttribute : NameChoiceAttribute
    {
        public override IReadOnlyList<string> Names => Predictors.Names;
    }

    sealed class ClockEstimatorNameAttribute : NameChoiceAttribute
    {
        public override IReadOnlyList<string> Names => ClockEstimators.Names;
    }
}
