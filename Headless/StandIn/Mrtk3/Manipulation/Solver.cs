using UnityEngine;

namespace MixedReality.Toolkit.SpatialManipulation;

[RequireComponent(typeof(SolverHandler))]
public abstract class Solver : MonoBehaviour
{
}
