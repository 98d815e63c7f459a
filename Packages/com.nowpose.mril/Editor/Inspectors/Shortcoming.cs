using System.Collections.Generic;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>A reference that is missing on components, and the object that a click assigns to it.</summary>
    sealed class Shortcoming
    {
        readonly List<Object> _components = new List<Object>();
        readonly string _field;
        readonly Object _remedy;

        /// <param name="field">Name of the serialised field.</param>
        /// <param name="remedy">The object to assign; null if only the user can choose.</param>
        public Shortcoming(string message, string field, Object remedy)
        {
            Message = message;
            _field = field;
            _remedy = remedy;
        }

        /// <summary>Description of the missing reference, and what to do.</summary>
        public string Message { get; }

        /// <summary>Label of the button; null without a button.</summary>
        public string FixLabel => _remedy == null ? null : "Use '" + _remedy.name + "'";

        /// <summary>Adds another component with the same missing reference.</summary>
        public void Add(Object component) => _components.Add(component);

        /// <summary>Sets the reference of all these components; the user can undo it.</summary>
        public void Fix()
        {
            using (var components = new SerializedObject(_components.ToArray()))
            {
                components.FindProperty(_field).objectReferenceValue = _remedy;
                components.ApplyModifiedProperties();
            }
        }
    }
}
