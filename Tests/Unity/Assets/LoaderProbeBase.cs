using UnityEngine;

namespace Nowpose.Unity.Tests.Assets;

public abstract class LoaderProbeBase : MonoBehaviour
{
    [SerializeField] float _inherited = 1;
    [SerializeField] bool _flag = false;
    float _private = 1;

    public float Inherited => _inherited;
    public bool Flag => _flag;
    public float Private => _private;
}
