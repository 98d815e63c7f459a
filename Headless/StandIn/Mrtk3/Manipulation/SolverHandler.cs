using UnityEngine;

namespace MixedReality.Toolkit.SpatialManipulation;

public class SolverHandler : MonoBehaviour
{
    [SerializeField] bool updateSolvers = true;

    public bool UpdateSolvers
    {
        get => updateSolvers;
        set => updateSolvers = value;
    }
}
