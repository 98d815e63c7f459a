using System.Reflection;
using UnityEngine.Serialization;

namespace UnityEditor;

public class SerializedObject : IDisposable
{
    readonly List<Action> _changes = new List<Action>();

    public SerializedObject(Object obj) : this(new[] { obj }) { }

    public SerializedObject(Object[] objs)
    {
        if (objs.Length == 0 || objs.Any(o => !o)) throw new ArgumentException("Object at index 0 is null", nameof(objs));
        targetObjects = objs;
    }

    public Object targetObject => targetObjects[0];
    public Object[] targetObjects { get; }
    public bool isEditingMultipleObjects => targetObjects.Length > 1;

    public SerializedProperty FindProperty(string propertyPath)
    {
        var (type, path, owner) = (targetObject.GetType(), new List<FieldInfo>(), (Func<object, object>)(o => o));
        foreach (var name in propertyPath.Split('.'))
        {
            var field = SerializedFields.Of(type).FirstOrDefault(f => f.Name == name);
            if (field == null) return null;
            if (path.Count > 0)
            {
                var (outer, before) = (path[^1], owner);
                owner = o => outer.GetValue(before(o));
            }
            path.Add(field);
            type = field.FieldType;
        }

        var last = path[^1];
        return new SerializedProperty(this, propertyPath, type, o => last.GetValue(owner(o)), (o, value) => last.SetValue(owner(o), value))
        { Drawer = PropertyDrawer.For(last) };
    }

    public void Update() => _changes.Clear();

    public bool ApplyModifiedProperties()
    {
        if (_changes.Count == 0) return false;

        Undo.RecordObjects(targetObjects, "Inspector");
        foreach (var change in _changes) change();
        _changes.Clear();
        return true;
    }

    public void Dispose() { }

    internal IEnumerable<SerializedProperty> All() =>
        SerializedFields.Of(targetObject.GetType()).Select(f => FindProperty(f.Name));

    /// <summary>Stores a change until <see cref="ApplyModifiedProperties"/> executes it.</summary>
    internal void Change(Action change) => _changes.Add(change);
}
