using UnityEngine;

namespace MixedReality.Toolkit.SpatialManipulation;

public class SolverHandler : MonoBehaviour
{
    [SerializeField] bool updateSolvers = true;
}
