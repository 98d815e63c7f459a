using System.Linq;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Draws a string field as a drop-down list of the names given by its attribute.</summary>
    /// <remarks>
    /// If the field contains a name that is not in the list, this name is shown as the last entry until the user selects another entry.
    /// </remarks>
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
