namespace MixedReality.Toolkit.UX;

public class PressableButton : StatefulInteractable
{
}
