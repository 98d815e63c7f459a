using UnityEngine.SceneManagement;

namespace UnityEngine;

public sealed partial class GameObject : Object
{
    readonly List<Component> _components = new();

    public GameObject() : this("New Game Object") { }

    public GameObject(string name) : this(name, World.Current.Scenes.Active) => Lifecycle.Activate(this);

    public GameObject(string name, params Type[] components) : this(name)
    {
        foreach (var component in components) AddComponent(component);
    }

    GameObject(string name, SceneContent scene)
    {
        this.name = name;
        Content = scene;
        transform = (Transform)Add(typeof(Transform));
        scene?.Add(this);
    }

    public Transform transform
    {
        get
        {
            ThrowIfDestroyed();
            return field;
        }
        private set;
    }

    public int layer { get; set; }

    public string tag { get; set; } = "Untagged";

    public bool activeSelf { get; private set; } = true;

    public bool activeInHierarchy { get; private set; }

    public Scene scene
    {
        get
        {
            ThrowIfDestroyed();
            return new Scene(Content);
        }
    }

    /// <summary>Components in the order in which they were added. The Transform is the first.</summary>
    internal IReadOnlyList<Component> Components => _components;

    /// <summary>Scene of the object; null for a prefab, and for a new object that has not been added to a scene.</summary>
    internal SceneContent Content { get; private set; }

    /// <summary>Creates an object that is not in a scene. Its scripts do not receive Awake before <see cref="SceneContent.Adopt"/>.</summary>
    internal static GameObject Detached(string name) => new(name, (SceneContent)null);

    public bool CompareTag(string tag) => this.tag == tag;

    public void SetActive(bool value)
    {
        ThrowIfDestroyed();
        if (activeSelf == value) return;

        activeSelf = value;
        Lifecycle.Refresh(this);
    }

    public Component AddComponent(Type componentType)
    {
        ThrowIfDestroyed();
        var required = Requirements.Of(componentType);
        if (required.Alone && GetComponent(componentType))
        {
            Debug.LogError(
                $"Can't add component '{componentType.Name}' to {name} because such a component is already added to the game object!", this);
            return null;
        }

        foreach (var type in required.Types)
        {
            if (!GetComponent(type)) AddComponent(type);
        }

        var component = Add(componentType);
        if (activeInHierarchy) component.Activated();
        return component;
    }

    public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

    /// <summary>Adds a component. Does not call its messages and does not add the components that it requires.</summary>
    internal Component Add(Type type)
    {
        if (_components.Count > 0 && typeof(Transform).IsAssignableFrom(type)) return TransformOf(type);

        var component = (Component)Construction.Create(type);
        component.AttachTo(this);
        _components.Add(component);
        return component;
    }

    /// <summary>Replaces the Transform with an object of a derived class, as Unity does. The stand-in supports this only without children.</summary>
    Transform TransformOf(Type type)
    {
        if (type.IsInstanceOfType(transform)) return transform;
        var replacing = (Transform)Construction.Create(type);
        replacing.AttachTo(this);
        _components[0] = replacing;
        transform = replacing;
        return replacing;
    }

    /// <summary>Sets <see cref="activeSelf"/> of an object that is not in a scene yet.</summary>
    internal void SetActiveSelf(bool value) => activeSelf = value;

    internal void SetActiveInHierarchy(bool value) => activeInHierarchy = value;

    internal void Remove(Component component) => _components.Remove(component);

    /// <summary>Sets the scene of the object and its descendants.</summary>
    internal void MoveTo(SceneContent scene)
    {
        Content = scene;
        for (var i = 0; i < transform.childCount; i++) transform.GetChild(i).gameObject.MoveTo(scene);
    }
}
