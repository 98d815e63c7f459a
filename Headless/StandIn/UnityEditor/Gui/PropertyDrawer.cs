using System;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace UnityEditor;

public abstract class GUIDrawer { }

public abstract class PropertyDrawer : GUIDrawer
{
    public PropertyAttribute attribute { get; private set; }

    public virtual void OnGUI(Rect position, SerializedProperty property, GUIContent label) { }

    /// <summary>The drawer that is declared for one of the field's attributes; null for none.</summary>
    internal static PropertyDrawer For(FieldInfo field)
    {
        foreach (var attribute in field.GetCustomAttributes<PropertyAttribute>())
        {
            var type = EditorAssemblies.Types.FirstOrDefault(t => t.GetCustomAttributes<CustomPropertyDrawer>().Any(d => d.Draws(attribute)));
            if (type == null) continue;
            var drawer = (PropertyDrawer)Activator.CreateInstance(type);
            drawer.attribute = attribute;
            return drawer;
        }
        return null;
    }
}
