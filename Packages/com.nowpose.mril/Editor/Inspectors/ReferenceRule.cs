using System;
using Nowpose.Editor.Messages;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule that a reference of a component must be set.</summary>
    sealed class ReferenceRule : IShortcomingRule
    {
        readonly Type _component, _above;
        readonly string _field, _message;
        readonly Func<Component, Object> _remedy;
        readonly Func<Component, bool> _applies;

        /// <param name="field">Name of the serialised field.</param>
        /// <param name="above">
        /// If the reference is empty, the component searches its own object and the parents for a component of this type. Null if the component does
        /// not search.
        /// </param>
        /// <param name="message">Message to the user.</param>
        /// <param name="remedy">Returns the object to assign; returns null if only the user can choose.</param>
        /// <param name="applies">Returns whether a component needs the reference; null if every component does.</param>
        public ReferenceRule(
            Type component, string field, Type above, string message, Func<Component, Object> remedy, Func<Component, bool> applies = null)
        {
            _applies = applies;
            _component = component;
            _field = field;
            _above = above;
            _message = message;
            _remedy = remedy;
        }

        public bool IsBrokenBy(Component component)
        {
            if (component.GetType() != _component || IsSet(component)) return false;
            if (_applies != null && !_applies(component)) return false;
            if (_above == null) return true;
            // The parents of a prefab asset are not checked, because the user may place its instances below an object with the required component.
            return !EditorUtility.IsPersistent(component) && component.gameObject.GetComponentInParent(_above, true) == null;
        }

        public Shortcoming Shortcoming(Component component)
        {
            var remedy = _remedy(component);
            return new Shortcoming(_message, remedy == null ? null : InspectorTexts.Use(remedy.name), Assign);
        }

        // The remedy differs between the components: each panel has texts of its own.
        void Assign(Object[] components)
        {
            foreach (var component in components)
            {
                var remedy = _remedy((Component)component);
                if (remedy != null) SerialisedField.Write(component, _field, field => field.objectReferenceValue = remedy);
            }
        }

        bool IsSet(Component component) => SerialisedField.Referenced<Object>(component, _field) != null;
    }
}
