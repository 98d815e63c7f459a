using System.Linq;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Draws a string as a drop-down of the names that its attribute lists.</summary>
    /// <remarks>A name that is not in the list stays in the field, as the last entry, until the user chooses another one.</remarks>
    [CustomPropertyDrawer(typeof(NameChoiceAttribute), true)]
    sealed class NameChoiceDrawer : PropertyDrawer
    {
        public override void OnGUI(Rect position, SerializedProperty property, GUIContent label)
        {
            var names = ((NameChoiceAttribute)attribute).Names.ToList();
            if (!names.Contains(property.stringValue)) names.Add(property.stringValue);

            label = EditorGUI.BeginProperty(position, label, property);
            EditorGUI.showMixedValue = property.hasMultipleDifferentValues;
            EditorGUI.BeginChangeCheck();
            var chosen = EditorGUI.Popup(
                position, label, names.IndexOf(property.stringValue), names.Select(name => new GUIContent(name)).ToArray());
            if (EditorGUI.EndChangeCheck()) property.stringValue = names[chosen];
            EditorGUI.showMixedValue = false;
            EditorGUI.EndProperty();
        }
    }
}
