using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor
{
    [CustomEditor(typeof(StatusPanel))]
    [CanEditMultipleObjects]
    sealed class StatusPanelEditor : LiveInspector
    {
    }
}
