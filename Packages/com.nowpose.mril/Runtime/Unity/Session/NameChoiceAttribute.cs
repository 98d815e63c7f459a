using System.Collections.Generic;
using Nowpose.Prediction;
using Nowpose.Sync;
using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>The Inspector shows a drop-down of names for the string field; the name itself is serialised.</summary>
    abstract class NameChoiceAttribute : PropertyAttribute
    {
        /// <summary>The names to choose from. The field may hold another one, as older assets or scripts may.</summary>
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
