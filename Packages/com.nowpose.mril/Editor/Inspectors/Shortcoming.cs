using System.Collections.Generic;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>A reference that components lack, and what it can be set to at a click.</summary>
    sealed class Shortcoming
    {
        readonly List<Object> _components = new List<Object>();
        readonly string _field;
        readonly Object _remedy;

        /// <param name="field">Name of the serialised field.</param>
        /// <param name="remedy">Null where only the user knows.</param>
        public Shortcoming(string message, string field, Object remedy)
        {
            Message = message;
            _field = field;
            _remedy = remedy;
        }

        /// <summary>What is missing, and what to do.</summary>
        public string Message { get; }

        /// <summary>What the button says; null where there is none.</summary>
        public string FixLabel => _remedy == null ? null : "Use '" + _remedy.name + "'";

        /// <summary>Another component that lacks the same.</summary>
        public void Add(Object component) => _components.Add(component);

        /// <summary>Sets the reference of all components that lack it, undoably.</summary>
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
