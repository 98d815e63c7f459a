using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Serialization;
using Object = UnityEngine.Object;

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
        var field = SerializedFields.Of(targetObject.GetType()).FirstOrDefault(f => f.Name == propertyPath);
        return field == null ? null : new SerializedProperty(
            this, propertyPath, field.FieldType, o => field.GetValue(o), (o, value) => field.SetValue(o, value))
        { Drawer = PropertyDrawer.For(field) };
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
