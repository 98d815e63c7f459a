using System;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule that a condition does not apply to a component in a scene. Only the user can choose the remedy.</summary>
    sealed class ConditionRule<T> : IShortcomingRule where T : Component
    {
        readonly Func<T, bool> _isBroken;
        readonly string _message;

        /// <param name="isBroken">Returns whether a component breaks the rule.</param>
        /// <param name="message">Message to the user.</param>
        public ConditionRule(Func<T, bool> isBroken, string message) => (_isBroken, _message) = (isBroken, message);

        public bool IsBrokenBy(Component component) => component is T checkedPart && !EditorUtility.IsPersistent(checkedPart) && _isBroken(checkedPart);

        public Shortcoming Shortcoming(Component component) => new Shortcoming(_message, null, null);
    }
}
