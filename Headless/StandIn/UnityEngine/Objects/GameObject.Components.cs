namespace UnityEngine;

public sealed partial class GameObject
{
    public Component GetComponent(Type type)
    {
        ThrowIfDestroyed();
        foreach (var component in _components)
        {
            if (type.IsInstanceOfType(component)) return component;
        }

        return null;
    }

    public T GetComponent<T>()
    {
        ThrowIfDestroyed();
        foreach (var component in _components)
        {
            if (component is T found) return found;
        }

        return default;
    }

    public bool TryGetComponent<T>(out T component)
    {
        component = GetComponent<T>();
        return component is not null;
    }

    public Component[] GetComponents(Type type)
    {
        ThrowIfDestroyed();
        return _components.FindAll(type.IsInstanceOfType).ToArray();
    }

    public T[] GetComponents<T>()
    {
        var found = new List<T>();
        GetComponents(found);
        return found.ToArray();
    }

    public void GetComponents<T>(List<T> results)
    {
        ThrowIfDestroyed();
        results.Clear();
        AddComponents(results);
    }

    public Component GetComponentInChildren(Type type, bool includeInactive)
    {
        if (includeInactive || activeInHierarchy)
        {
            var own = GetComponent(type);
            if (own is not null) return own;
        }

        for (var i = 0; i < transform.childCount; i++)
        {
            var below = transform.GetChild(i).gameObject.GetComponentInChildren(type, includeInactive);
            if (below is not null) return below;
        }

        return null;
    }

    public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);

    public T GetComponentInChildren<T>(bool includeInactive) => (T)(object)GetComponentInChildren(typeof(T), includeInactive);

    public Component GetComponentInParent(Type type, bool includeInactive)
    {
        for (var t = transform; t is not null; t = t.parent)
        {
            var found = includeInactive || t.gameObject.activeInHierarchy ? t.gameObject.GetComponent(type) : null;
            if (found is not null) return found;
        }

        return null;
    }

    public T GetComponentInParent<T>() => GetComponentInParent<T>(false);

    public T GetComponentInParent<T>(bool includeInactive) => (T)(object)GetComponentInParent(typeof(T), includeInactive);

    public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

    public T[] GetComponentsInChildren<T>(bool includeInactive)
    {
        var found = new List<T>();
        GetComponentsInChildren(includeInactive, found);
        return found.ToArray();
    }

    public void GetComponentsInChildren<T>(List<T> results) => GetComponentsInChildren(false, results);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> results)
    {
        ThrowIfDestroyed();
        results.Clear();
        AddComponentsBelow(includeInactive, results);
    }

    public T[] GetComponentsInParent<T>(bool includeInactive)
    {
        var found = new List<T>();
        for (var t = transform; t is not null; t = t.parent)
        {
            if (includeInactive || t.gameObject.activeInHierarchy) t.gameObject.AddComponents(found);
        }

        return found.ToArray();
    }

    void AddComponents<T>(List<T> results)
    {
        foreach (var component in _components)
        {
            if (component is T found) results.Add(found);
        }
    }

    void AddComponentsBelow<T>(bool includeInactive, List<T> results)
    {
        if (includeInactive || activeInHierarchy) AddComponents(results);
        for (var i = 0; i < transform.childCount; i++) transform.GetChild(i).gameObject.AddComponentsBelow(includeInactive, results);
    }
}
