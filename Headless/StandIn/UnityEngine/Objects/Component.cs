namespace UnityEngine;

public class Component : Object
{
    GameObject _gameObject;

    public GameObject gameObject
    {
        get
        {
            ThrowIfDestroyed();
            return _gameObject;
        }
    }

    public Transform transform => gameObject.transform;

    internal GameObject Owner => _gameObject;

    internal override Object NameOwner => _gameObject is null ? this : _gameObject;

    public bool CompareTag(string tag) => gameObject.CompareTag(tag);

    public T GetComponent<T>() => gameObject.GetComponent<T>();
    public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);
    public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();
    public T GetComponentInChildren<T>(bool includeInactive) => gameObject.GetComponentInChildren<T>(includeInactive);
    public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();
    public T GetComponentInParent<T>(bool includeInactive) => gameObject.GetComponentInParent<T>(includeInactive);
    public Component[] GetComponents(Type type) => gameObject.GetComponents(type);
    public T[] GetComponents<T>() => gameObject.GetComponents<T>();
    public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);
    public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();
    public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);
    public void GetComponentsInChildren<T>(List<T> results) => gameObject.GetComponentsInChildren(results);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> result) =>
        gameObject.GetComponentsInChildren(includeInactive, result);

    public T[] GetComponentsInParent<T>(bool includeInactive) => gameObject.GetComponentsInParent<T>(includeInactive);

    internal void AttachTo(GameObject owner) => _gameObject = owner;

    /// <summary>Called when the GameObject becomes active, or when the component is added to an active GameObject.</summary>
    internal virtual void Activated() { }

    /// <summary>Called when the GameObject becomes inactive.</summary>
    internal virtual void Deactivated() { }

    /// <summary>Called immediately before the component is destroyed, when a comparison with null still returns false.</summary>
    internal virtual void Destroying() { }
}
