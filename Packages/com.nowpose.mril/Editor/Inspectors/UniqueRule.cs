using System;
using System.Linq;
using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule that no two components of a session show the same robot or frame.</summary>
    sealed class UniqueRule<T> : IShortcomingRule where T : Component
    {
        readonly Func<T, T, bool> _areSame;
        readonly Func<T, T, string> _message;

        /// <param name="areSame">Returns whether two components of a session are in conflict.</param>
        /// <param name="message">Returns the message to the user about a component and the first other one.</param>
        public UniqueRule(Func<T, T, bool> areSame, Func<T, T, string> message) => (_areSame, _message) = (areSame, message);

        public bool IsBrokenBy(Component component) => component is T shown && !EditorUtility.IsPersistent(shown) && OtherOf(shown) != null;

        public Shortcoming Shortcoming(Component component) => new Shortcoming(_message((T)component, OtherOf((T)component)), null, null);

        T OtherOf(T shown)
        {
            var session = SceneSearch.SessionOf(shown);
            if (session == null) return null;
            return SceneSearch.All<T>(shown).FirstOrDefault(other => other != shown && _areSame(shown, other) && SceneSearch.SessionOf(other) == session);
        }
    }
}
