using System.Collections.Generic;
using Nowpose.Prediction;
using Nowpose.Sync;
using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Shows a string field in the Inspector as a drop-down list of names. The field serialises the name.</summary>
    abstract class NameChoiceAttribute : PropertyAttribute
    {
        /// <summary>The names in the list. The field may contain another name, for example from an older asset or a script.</summary>
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
