using System.Collections.Generic;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>
    /// A missing reference on one or more components, and the object that a button in the Inspector assigns to it, if there is one.
    /// </summary>
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

        /// <summary>Message to the user, which names the missing reference and the remedy.</summary>
        public string Message { get; }

        /// <summary>Label of the button; null if only the user can choose an object.</summary>
        public string FixLabel => _remedy == null ? null : "Use '" + _remedy.name + "'";

        /// <summary>Adds another component with the same missing reference.</summary>
        public void Add(Object component) => _components.Add(component);

        /// <summary>Assigns the object to the reference on all these components. The user can undo the assignment.</summary>
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
