namespace UnityEngine.SceneManagement;

public enum LoadSceneMode
{
    Single = 0,
    Additive = 1,
}
