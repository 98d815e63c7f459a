using System;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>A reference that a component cannot do without.</summary>
    sealed class ReferenceRule
    {
        readonly Type _component, _above;
        readonly string _field, _message;
        readonly Func<Component, Object> _remedy;
        readonly Func<Component, bool> _applies;

        /// <param name="field">Name of the serialised reference.</param>
        /// <param name="above">What is found by itself on the object or above, so that the reference may be empty; null where nothing is.</param>
        /// <param name="remedy">What the reference can be set to; gives null where only the user knows.</param>
        /// <param name="applies">Whether the component needs the reference; null for always.</param>
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
            // A prefab in the project may be meant to be placed below what it needs.
            return !EditorUtility.IsPersistent(component) && component.gameObject.GetComponentInParent(_above, true) == null;
        }

        public Shortcoming Shortcoming(Component component) => new Shortcoming(_message, _field, _remedy(component));

        bool IsSet(Component component)
        {
            using (var serialised = new SerializedObject(component)) return serialised.FindProperty(_field).objectReferenceValue != null;
        }
    }
}
