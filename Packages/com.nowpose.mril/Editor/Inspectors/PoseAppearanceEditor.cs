using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor
{
    [CustomEditor(typeof(PoseAppearance))]
    [CanEditMultipleObjects]
    sealed class PoseAppearanceEditor : LiveInspector
    {
    }
}
