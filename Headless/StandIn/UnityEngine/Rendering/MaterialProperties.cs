namespace UnityEngine.Rendering;

/// <summary>Values of the properties of one type, by the ids of the property names.</summary>
sealed class MaterialProperties<T>
{
    readonly Dictionary<int, T> _values = new();

    internal int Count => _values.Count;

    internal bool Has(int id) => _values.ContainsKey(id);

    internal T Get(int id) => _values.TryGetValue(id, out var value) ? value : default;

    internal void Set(int id, T value) => _values[id] = value;

    internal void Clear() => _values.Clear();

    internal void CopyFrom(MaterialProperties<T> other)
    {
        if (ReferenceEquals(other, this)) return;

        _values.Clear();
        foreach (var pair in other._values) _values[pair.Key] = pair.Value;
    }
}
