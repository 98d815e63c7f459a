using System.Reflection;

namespace UnityEditor;

public abstract class GUIDrawer { }

public abstract class PropertyDrawer : GUIDrawer
{
    public PropertyAttribute attribute { get; private set; }

    public virtual void OnGUI(Rect position, SerializedProperty property, GUIContent label) { }

    /// <summary>Creates the drawer that is declared for an attribute of a field; returns null if there is none.</summary>
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
